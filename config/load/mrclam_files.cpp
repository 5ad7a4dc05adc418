#include "config/load/mrclam_files.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "config/load/cut_row.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "config/load/text_format.hpp"

namespace wheelwright::config {
namespace {

using std::string_view;

struct Field {
  string_view name;
  double largest;
};

constexpr double largest_time_s = 1e10;
constexpr std::array odometry_fields{Field{"time [s]", largest_time_s}, Field{"forward velocity [m/s]", 5.0},
                                     Field{"angular velocity [rad/s]", 50.0}};
constexpr std::array ground_truth_fields{Field{"time [s]", largest_time_s}, Field{"x [m]", 1e4},
                                         Field{"y [m]", 1e4}, Field{"orientation [rad]", 1e4}};

// Microseconds, as the log will print them, so that two rows that print alike are seen here.
std::int64_t microseconds(double t_s) {
  return std::llround(t_s * 1e6);
}

template <std::size_t Count>
struct Row {
  std::int64_t t_us = 0;
  std::array<double, Count> values{};  // as in the file, time first
};

template <std::size_t Count>
class Reader {
 public:
  Reader(const MrclamText& file, const std::array<Field, Count>& fields, bool times_may_repeat)
      : file_(file), fields_(fields), times_may_repeat_(times_may_repeat) {}

  std::vector<Row<Count>> run() {
    string_view rest = file_.text;
    while (!rest.empty()) {
      const auto end = rest.find('\n');
      ++line_;
      is_open_ended_ = end == string_view::npos;
      take_line(rest.substr(0, end));
      rest = end == string_view::npos ? string_view{} : rest.substr(end + 1);
    }
    if (rows_.empty()) throw LogError(file_.name + ": holds no rows; each is '" + header() + "'");
    return std::move(rows_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw LogError(file_.name + ":" + std::to_string(line_) + ": " + what);
  }

  std::string header() const {
    std::string text;
    for (const Field& field : fields_) text += (text.empty() ? "" : ", ") + std::string(field.name);
    return text;
  }

  void take_line(string_view line) {
    std::array<string_view, Count> words{};
    std::size_t count = 0;
    constexpr string_view blanks = " \t\r";
    for (auto begin = line.find_first_not_of(blanks); begin != string_view::npos;
         begin = line.find_first_not_of(blanks)) {
      line.remove_prefix(begin);
      if (count == 0 && line.front() == '#') return;
      const string_view word = line.substr(0, line.find_first_of(blanks));
      if (count < Count) words[count] = word;
      ++count;
      line.remove_prefix(word.size());
    }
    if (count == 0) return;
    const bool is_cut = count < Count || (count == Count && has_lost_figures(words[Count - 1], field_above_));
    if (is_open_ended_ && is_cut) fail(std::string(cut_row_text));
    field_above_ = words[Count - 1];
    if (count != Count) {
      fail("has " + std::to_string(count) + " fields, but must have " + std::to_string(Count) + ": " +
           header());
    }
    Row<Count> row;
    for (std::size_t i = 0; i < Count; ++i) row.values[i] = number(words[i], fields_[i]);
    row.t_us = microseconds(row.values[0]);
    check_time(row.t_us);
    rows_.push_back(row);
  }

  double number(string_view word, const Field& field) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end == word.data() + word.size() && std::isfinite(value) &&
        std::abs(value) <= field.largest) {
      return value;
    }
    fail(std::string(field.name) + " is '" + excerpt(word) + "', but must be a number of at most " +
         plain_number(field.largest) + " in size");
  }

  void check_time(std::int64_t t_us) const {
    if (rows_.empty()) return;
    const std::int64_t last = rows_.back().t_us;
    if (t_us > last || (t_us == last && times_may_repeat_)) return;
    fail("time goes from " + fixed_number(static_cast<double>(last) * 1e-6, 3) + " to " +
         fixed_number(static_cast<double>(t_us) * 1e-6, 3) + " s, but must rise");
  }

  const MrclamText& file_;
  const std::array<Field, Count>& fields_;
  bool times_may_repeat_;
  std::size_t line_ = 0;
  bool is_open_ended_ = false;  // no line break behind the line
  string_view field_above_;     // the last of the row above
  std::vector<Row<Count>> rows_;
};

using Command = Row<odometry_fields.size()>;
using Reference = Row<ground_truth_fields.size()>;

MrclamRun join(const std::vector<Command>& commands, const std::vector<Reference>& references,
               const MrclamOptions& options) {
  MrclamRun run;
  auto reference = references.begin();
  for (; reference != references.end() && reference->t_us < commands.front().t_us; ++reference) {
    ++run.references_before;
  }
  WheelPair command_m_s;
  const auto row_at = [&](std::int64_t t_us) -> DriveSample& {
    DriveSample sample;
    sample.t_s = static_cast<double>(t_us - commands.front().t_us) * 1e-6;
    sample.command_m_s = command_m_s;
    return run.log.samples.emplace_back(sample);
  };
  const auto put_reference = [&](DriveSample& sample) {
    sample.reference_x_m = reference->values[1];
    sample.reference_y_m = reference->values[2];
    sample.reference_theta_rad = reference->values[3];
    ++run.references;
    ++reference;
  };
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Command& command = commands[i];
    if (i + 1 < commands.size() && commands[i + 1].t_us == command.t_us) {
      ++run.superseded;
      continue;
    }
    while (reference != references.end() && reference->t_us < command.t_us)
      put_reference(row_at(reference->t_us));
    command_m_s = wheels_of_twist({command.values[1], command.values[2]}, options.wheel_base_m);
    DriveSample& row = row_at(command.t_us);
    ++run.commands;
    if (reference != references.end() && reference->t_us == command.t_us) put_reference(row);
  }
  run.references_after = static_cast<std::size_t>(references.end() - reference);
  return run;
}

MrclamText read(const std::filesystem::path& path) {
  return {path.string(), read_text_or_throw<LogError>(path, log_file)};
}

}  // namespace

MrclamRun parse_mrclam_run(const MrclamText& odometry, const MrclamText& ground_truth,
                           const MrclamOptions& options) {
  const auto commands = Reader(odometry, odometry_fields, true).run();
  const auto references = Reader(ground_truth, ground_truth_fields, false).run();
  MrclamRun run = join(commands, references, options);
  if (run.references == 0) {
    throw LogError(ground_truth.name + ": no pose lies within the time of " + odometry.name +
                   "; the two files must be of one robot and one run");
  }
  const auto file_name = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  run.log.name = odometry.name;
  run.log.wheel_base_m = options.wheel_base_m;
  run.log.period_s = options.period_s;
  run.log.other_metadata = {
      {"robot", "iRobot Create (MRCLAM)"},
      {"source", file_name(odometry.name) + ", " + file_name(ground_truth.name)},
      {"start_unix_s", fixed_number(static_cast<double>(commands.front().t_us) * 1e-6, 6)}};
  return run;
}

MrclamRun load_mrclam_run(const std::filesystem::path& odometry, const std::filesystem::path& ground_truth,
                          const MrclamOptions& options) {
  const MrclamText commands = read(odometry);
  return parse_mrclam_run(commands, read(ground_truth), options);
}

}  // namespace wheelwright::config

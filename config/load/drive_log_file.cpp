#include "config/load/drive_log_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <new>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "config/load/ascii_text.hpp"
#include "config/load/cut_row.hpp"
#include "config/load/drive_log_columns.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "config/load/text_format.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::config {
namespace {

using namespace drive_log;
using std::string_view;

constexpr std::size_t absent = std::numeric_limits<std::size_t>::max();
constexpr double largest_command_m_s = 100.0;
constexpr double restart_below_s = 1.0;
constexpr std::size_t max_rows = 10'000'000;  // two days of 18 ms
constexpr std::size_t max_heads = 1'000'000;  // columns and lines of metadata, times runs
constexpr double max_off_period = 50.0;
constexpr std::size_t min_rows_for_period = 5;

std::optional<double> to_number(string_view field) {
  double value = 0.0;
  if (!field.empty() && field.front() == '+') field.remove_prefix(1);
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return value;
}

class Parser {
 public:
  Parser(string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  std::vector<DriveLog> run() {
    string_view line;
    while (next_line(line)) {
      if (line.empty()) continue;
      if (line.front() == '#') {
        metadata_line(line.substr(1));
      } else if (column_count_ == 0) {
        header_line(line);
      } else {
        sample_line(line);
      }
    }
    if (column_count_ == 0) fail("the header row 't,cmd_left,cmd_right,...' is missing");
    if (runs_.empty()) fail("holds no samples");
    for (auto& run : runs_) complete(run);
    return std::move(runs_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw LogError(name_ + ":" + std::to_string(line_number_) + ": " + what);
  }

  bool next_line(string_view& line) {
    if (text_.empty()) return false;
    const auto end = text_.find('\n');
    line = trim(text_.substr(0, end));
    is_open_ended_ = end == string_view::npos;
    text_ = end == string_view::npos ? string_view{} : text_.substr(end + 1);
    ++line_number_;
    return true;
  }

  double positive_metadata(string_view key, string_view value, double minimum, double maximum) const {
    const auto number = to_number(value);
    if (!number || !(*number >= minimum) || *number > maximum) {
      fail("'" + std::string(key) + "' is '" + excerpt(value) + "', but must be a number from " +
           plain_number(minimum) + " to " + plain_number(maximum));
    }
    return *number;
  }

  void metadata_line(string_view text) {
    const auto colon = text.find(':');
    if (colon == string_view::npos) return;
    const string_view key = trim(text.substr(0, colon));
    const string_view value = trim(text.substr(colon + 1));
    if (key == "wheelwright_drive_log") {
      if (value != "1")
        fail("this is a drive log of version " + excerpt(value) + "; only version 1 is known");
    } else if (key == "wheel_base_m") {
      header_.wheel_base_m = positive_metadata(key, value, 0.001, 10.0);
    } else if (key == "period_s") {
      header_.period_s = positive_metadata(key, value, 0.0001, 10.0);
    } else if (key == "metres_per_tick_left") {
      metres_per_tick_.left = positive_metadata(key, value, 1e-9, 1.0);
    } else if (key == "metres_per_tick_right") {
      metres_per_tick_.right = positive_metadata(key, value, 1e-9, 1.0);
    } else {
      header_.other_metadata.emplace_back(key, value);
    }
  }

  void header_line(string_view line) {
    position_.fill(absent);
    std::unordered_set<string_view> seen;
    while (true) {
      const auto comma = line.find(',');
      const string_view name = trim(line.substr(0, comma));
      if (!seen.insert(name).second) fail("column '" + excerpt(name) + "' occurs twice");
      const auto* known = std::find(column_names.begin(), column_names.end(), name);
      if (known != column_names.end()) {
        position_.at(static_cast<std::size_t>(known - column_names.begin())) = column_count_;
      } else {
        extra_position_.push_back(column_count_);
        header_.extra_columns.push_back({std::string(name), {}, {}});
      }
      ++column_count_;
      if (comma == string_view::npos) break;
      line.remove_prefix(comma + 1);
    }
    for (const Column needed : {time, cmd_left, cmd_right}) {
      if (position_[needed] == absent) {
        fail("the header row has no column '" + std::string(column_names[needed]) + "'");
      }
    }
    if ((position_[ticks_left] == absent) != (position_[ticks_right] == absent)) {
      fail("ticks_left and ticks_right must both be there or neither");
    }
    header_.name = name_;
  }

  void split(string_view line) {
    values_.clear();
    while (true) {
      const auto comma = line.find(',');
      values_.push_back(trim(line.substr(0, comma)));
      if (comma == string_view::npos) break;
      line.remove_prefix(comma + 1);
    }
    const bool is_cut = values_.size() < column_count_ ||
                        (values_.size() == column_count_ && has_lost_figures(values_.back(), field_above_));
    if (is_open_ended_ && is_cut) fail(std::string(cut_row_text));
    field_above_ = values_.back();
    if (values_.size() != column_count_) {
      fail("has " + std::to_string(values_.size()) + " fields, but the header names " +
           std::to_string(column_count_) + " columns");
    }
  }

  std::optional<double> field(Column column, double limit) const {
    const std::size_t at = position_.at(column);
    if (at == absent || values_[at].empty()) return std::nullopt;
    const auto number = to_number(values_[at]);
    if (!number || !std::isfinite(*number) || std::abs(*number) > limit) {
      fail("'" + std::string(column_names[column]) + "' is '" + excerpt(values_[at]) +
           "', but must be a number of at most " + plain_number(limit) + " in size");
    }
    return number;
  }

  void sample_line(string_view line) {
    split(line);
    DriveSample sample;
    const auto t = field(time, 1e9);
    if (!t) fail("'t' is empty; each row needs its time in seconds");
    sample.t_s = *t;
    if (++rows_ > max_rows) {
      fail("holds more than " + std::to_string(max_rows) + " rows; split the file");
    }
    start_run_if_needed(sample.t_s);
    DriveLog& run = runs_.back();
    const DriveSample* before = run.samples.empty() ? nullptr : &run.samples.back();

    const auto left = field(cmd_left, largest_command_m_s);
    const auto right = field(cmd_right, largest_command_m_s);
    if ((!left || !right) && before == nullptr) fail("the first row of a run needs cmd_left and cmd_right");
    sample.command_m_s = {left ? *left : before->command_m_s.left,
                          right ? *right : before->command_m_s.right};

    const auto counts_left = field(ticks_left, largest_tick_count);
    const auto counts_right = field(ticks_right, largest_tick_count);
    if (counts_left && counts_right) sample.ticks = {std::llround(*counts_left), std::llround(*counts_right)};
    constexpr double anything = 1e9;
    sample.reference_x_m = field(ref_x, anything);
    sample.reference_y_m = field(ref_y, anything);
    sample.reference_theta_rad = field(ref_theta, anything);
    sample.gyro_z_rad_s = field(gyro_z, anything);
    sample.battery_v = field(battery_v, anything);
    run.samples.push_back(sample);
    for (std::size_t i = 0; i < extra_position_.size(); ++i) {
      add_extra(run.extra_columns[i], values_[extra_position_[i]]);
    }
  }

  static void add_extra(ExtraColumn& column, string_view field) {
    const auto number = to_number(field);
    const bool is_text = !number && !field.empty();
    if (is_text && column.texts.empty()) {
      for (const double value : column.values) {
        column.texts.push_back(std::isnan(value) ? std::string() : plain_number(value));
      }
    }
    column.values.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (is_text || !column.texts.empty()) column.texts.emplace_back(field);
  }

  void start_run_if_needed(double t_s) {
    if (!runs_.empty()) {
      const double last = runs_.back().samples.back().t_s;
      if (t_s > last) return;
      if (t_s >= restart_below_s || t_s == last) {
        fail("time goes from " + plain_number(last) + " to " + plain_number(t_s) +
             " s, but must rise (a new run starts below 1 s)");
      }
    }
    check_run_count();
    runs_.push_back(header_);
    runs_.back().first_line = line_number_;
  }

  // Each run has the head of the file as its own.
  void check_run_count() const {
    const std::size_t of_each = 1 + extra_position_.size() + header_.other_metadata.size();
    if ((runs_.size() + 1) * of_each <= max_heads) return;
    fail("here begins run " + std::to_string(runs_.size() + 1) + " of a log with " +
         std::to_string(of_each - 1) +
         " further columns and lines of metadata, which is more than fits; split the file");
  }

  void complete(DriveLog& run) const {
    if (run.wheel_base_m <= 0.0)
      throw LogError(name_ + ": '# wheel_base_m: ...' is missing above the header row");
    const bool any_ticks = std::any_of(run.samples.begin(), run.samples.end(),
                                       [](const DriveSample& sample) { return sample.ticks.has_value(); });
    if (any_ticks && (metres_per_tick_.left <= 0.0 || metres_per_tick_.right <= 0.0)) {
      throw LogError(name_ + ": has tick columns, but no '# metres_per_tick_left: ...' and '..._right: ...'");
    }
    if (metres_per_tick_.left > 0.0 && metres_per_tick_.right > 0.0) run.metres_per_tick = metres_per_tick_;
    if (run.period_s <= 0.0) {
      run.period_s = median_step(run);
    } else {
      check_period(run);
    }
  }

  // Rows may be missing, or lie between the periods, but not by the hundred.
  void check_period(const DriveLog& run) const {
    if (run.samples.size() < min_rows_for_period) return;
    const double step_s = median_step(run);
    if (run.period_s <= max_off_period * step_s && step_s <= max_off_period * run.period_s) return;
    throw LogError(name_ + ":" + std::to_string(run.first_line) + ": its rows are " + plain_number(step_s) +
                   " s apart (median), but '# period_s' says " + plain_number(run.period_s) +
                   " s; correct it, or leave it out");
  }

  double median_step(const DriveLog& run) const {
    if (run.samples.size() < 2) throw LogError(name_ + ": '# period_s: ...' is missing above the header row");
    std::vector<double> steps;
    for (std::size_t i = 1; i < run.samples.size(); ++i) {
      steps.push_back(run.samples[i].t_s - run.samples[i - 1].t_s);
    }
    return median(std::move(steps));
  }

  string_view text_;
  std::string name_;
  std::size_t line_number_ = 0;
  DriveLog header_;
  WheelPair metres_per_tick_;
  std::size_t column_count_ = 0;
  std::array<std::size_t, column_count> position_{};
  std::vector<std::size_t> extra_position_;
  std::vector<string_view> values_;
  string_view field_above_;     // the last of the row above
  bool is_open_ended_ = false;  // no line break behind the line
  std::size_t rows_ = 0;
  std::vector<DriveLog> runs_;
};

}  // namespace

std::vector<DriveLog> parse_drive_logs(const std::string& text, const std::string& name) {
  return Parser(text, name).run();
}

std::vector<DriveLog> load_drive_logs(const std::filesystem::path& path) {
  try {
    return parse_drive_logs(read_text_or_throw<LogError>(path, log_file), path.string());
  } catch (const std::bad_alloc&) {
    throw LogError(path.string() + ": is too large for the free memory of this machine; split the file");
  }
}

DriveLog load_drive_log(const std::filesystem::path& path) {
  auto runs = load_drive_logs(path);
  if (runs.size() != 1) {
    throw LogError(path.string() + ": holds " + std::to_string(runs.size()) +
                   " runs (the second starts in line " + std::to_string(runs[1].first_line) +
                   "), but one is wanted here; split the file");
  }
  return std::move(runs.front());
}

}  // namespace wheelwright::config

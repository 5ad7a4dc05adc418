#include "daemon/recording/lateness_file.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <sstream>

#include "config/load/drive_log_file.hpp"

namespace wheelwright::daemon {
namespace {

double as_microseconds(std::chrono::nanoseconds time) {
  return 1e-3 * static_cast<double>(time.count());
}

std::uint64_t count_of(std::int64_t value) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(value, 0));
}

// The whole word as a number that is not below zero.
template <typename Number>
bool read_number(std::string_view word, Number& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc{} && end == word.data() + word.size() && number >= Number{0} &&
         std::isfinite(static_cast<double>(number));
}

class Parser {
 public:
  Parser(const std::string& text, const std::string& name) : lines_(text), name_(name) {}

  LatenessRecord parse() {
    std::string line;
    while (std::getline(lines_, line)) {
      ++line_number_;
      if (line.starts_with("# ")) {
        note(line.substr(2));
      } else {
        add_bin(line);
      }
    }
    if (entries_["wheelwright_lateness"] != "1") fail("is no '# wheelwright_lateness: 1'");
    take("period_s", record_.period_s);
    take("wake_ups", record_.wake_ups);
    take("overruns", record_.overruns);
    take("skipped_periods", record_.skipped_periods);
    take("commands_late", record_.commands_late);
    take("largest_us", record_.largest_us);
    record_.system = entries_["system"];
    return std::move(record_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw config::LogError(name_ + ": " + what); }

  void note(const std::string& line) {
    const auto colon = line.find(": ");
    if (colon != std::string::npos) entries_[line.substr(0, colon)] = line.substr(colon + 2);
  }

  void add_bin(const std::string& line) {
    const auto space = line.find(' ');
    LatenessBin bin;
    const bool sound = space != std::string::npos &&
                       read_number(std::string_view(line).substr(0, space), bin.upper_edge_us) &&
                       read_number(std::string_view(line).substr(space + 1), bin.wake_ups);
    const bool rises = record_.bins.empty() || bin.upper_edge_us > record_.bins.back().upper_edge_us;
    if (!sound || !rises) {
      throw config::LogError(name_ + ":" + std::to_string(line_number_) + ": is '" + line +
                             "', but must be a rising edge in microseconds and a count");
    }
    record_.bins.push_back(bin);
  }

  template <typename Number>
  void take(const std::string& key, Number& number) {
    const std::string& text = entries_[key];
    if (!read_number(text, number))
      fail("'# " + key + "' is '" + text + "', but must be a number that is not below zero");
  }

  std::istringstream lines_;
  const std::string& name_;
  std::size_t line_number_ = 0;
  std::map<std::string, std::string> entries_;
  LatenessRecord record_;
};

}  // namespace

double LatenessRecord::quantile_us(double share) const {
  const double wanted = share * static_cast<double>(wake_ups);
  double seen = 0.0;
  for (const LatenessBin& bin : bins) {
    seen += static_cast<double>(bin.wake_ups);
    if (seen >= wanted) return bin.upper_edge_us;
  }
  return largest_us;
}

LatenessRecord lateness_record(const roomba::LatenessHistogram& lateness, const roomba::LoopCounts& counts,
                               double period_s, const std::string& system) {
  LatenessRecord record;
  record.system = system;
  record.period_s = period_s;
  record.wake_ups = lateness.count();
  record.overruns = count_of(counts.overruns);
  record.skipped_periods = count_of(counts.skipped_periods);
  record.commands_late = count_of(counts.commands_late);
  record.largest_us = as_microseconds(lateness.largest());
  for (std::size_t bin = 0; bin < roomba::LatenessHistogram::bins; ++bin) {
    if (lateness.in_bin(bin) == 0) continue;
    const auto edge = std::min(roomba::LatenessHistogram::upper_edge(bin), lateness.largest());
    record.bins.push_back({as_microseconds(edge), lateness.in_bin(bin)});
  }
  return record;
}

std::string lateness_text(const LatenessRecord& record) {
  std::string text = fmt::format(
      "# wheelwright_lateness: 1\n# system: {}\n# period_s: {}\n# wake_ups: {}\n# overruns: {}\n"
      "# skipped_periods: {}\n# commands_late: {}\n# largest_us: {:.3f}\n"
      "# columns: upper edge in us, wake-ups\n",
      record.system, record.period_s, record.wake_ups, record.overruns, record.skipped_periods,
      record.commands_late, record.largest_us);
  for (const LatenessBin& bin : record.bins)
    text += fmt::format("{:.3f} {}\n", bin.upper_edge_us, bin.wake_ups);
  return text;
}

LatenessRecord parse_lateness(const std::string& text, const std::string& name) {
  return Parser(text, name).parse();
}

}  // namespace wheelwright::daemon

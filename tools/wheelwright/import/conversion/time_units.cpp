#include "tools/wheelwright/import/conversion/time_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "config/load/ascii_text.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_steps = 100'000;  // of which the median is taken
constexpr double default_period_s = 0.03;
constexpr double max_period_s = 5.0;    // of rows with a calendar time
constexpr double max_day_step = 4e-5;   // of days: 3.5 s; as seconds 25 kHz
constexpr double min_day_number = 2e4;  // 1954 by Excel, days since 1899-12-30
constexpr double max_day_number = 8e5;  // 2190 by MATLAB, days since the year 0
constexpr double wrap_steps = 20.0;     // in which a counter goes past its end

struct Numbers {
  double size = 0.0;
  bool whole = true;
  double step = 0.0;  // median of those that rise; the mean of all where the clock is coarser than the rows
};

Numbers examine(const std::vector<double>& times) {
  Numbers numbers;
  std::vector<double> steps;
  double last = std::numeric_limits<double>::quiet_NaN();
  for (const double t : times) {
    if (!std::isfinite(t)) continue;
    numbers.size = std::max(numbers.size, std::abs(t));
    numbers.whole = numbers.whole && t == std::round(t);
    if (t > last && steps.size() < max_steps) steps.push_back(t - last);
    last = t;
  }
  if (steps.empty()) return numbers;
  numbers.step = median(steps);
  const auto finite = std::ranges::count_if(times, [](double t) { return std::isfinite(t); });
  const double mean = std::accumulate(steps.begin(), steps.end(), 0.0) / static_cast<double>(finite);
  if (numbers.whole && steps.size() < max_steps && 2.0 * mean < numbers.step) numbers.step = mean;
  return numbers;
}

// Steps that are far too short for seconds, of numbers that spreadsheets give to days.
bool are_days(const Numbers& numbers, std::optional<double> period_s) {
  const bool is_dated = numbers.size > min_day_number && numbers.size < max_day_number;
  const bool is_of_one_day = numbers.size <= 1.0;
  if (numbers.whole || !(is_dated || is_of_one_day) || numbers.step > max_day_step) return false;
  if (!period_s) return true;
  const auto off = [&](double seconds) { return std::abs(std::log(numbers.step * seconds / *period_s)); };
  return off(seconds_in(TimeUnit::day)) < off(1.0);
}

// Since 1970, between 1989 and 2109, at steps that rows of a log have.
std::optional<TimeUnit> epoch_unit(const Numbers& numbers) {
  constexpr double first_s = 6e8;
  constexpr double last_s = 4.4e9;
  for (const TimeUnit unit : {TimeUnit::s, TimeUnit::ms, TimeUnit::us, TimeUnit::ns}) {
    const double size_s = numbers.size * seconds_in(unit);
    if (size_s > first_s && size_s < last_s && numbers.step * seconds_in(unit) <= max_period_s) return unit;
  }
  return std::nullopt;
}

// Past the end of a counter of so many, forth within a few steps.
bool is_wrap(double before, double after, double modulus, double step) {
  const double forth = after - before + modulus;
  return forth > 0.0 && forth <= wrap_steps * step &&
         (std::abs(modulus - before) <= wrap_steps * step ||
          std::abs(0.5 * modulus - before) <= wrap_steps * step);
}

}  // namespace

double seconds_in(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::cs:
      return 1e-2;
    case TimeUnit::ms:
      return 1e-3;
    case TimeUnit::us:
      return 1e-6;
    case TimeUnit::ns:
      return 1e-9;
    case TimeUnit::day:
      return 86400.0;
    case TimeUnit::min:
      return 60.0;
    case TimeUnit::h:
      return 3600.0;
    case TimeUnit::s:
    case TimeUnit::frame:
    case TimeUnit::hms:
    case TimeUnit::iso:
      break;
  }
  return 1.0;
}

std::string_view in_words(TimeUnit unit) {
  constexpr std::array<std::string_view, 11> names{
      "seconds", "milliseconds",           "microseconds", "nanoseconds", "hours, minutes and seconds",
      "dates",   "hundredths of a second", "days",         "frames",      "minutes",
      "hours"};
  return names.at(static_cast<std::size_t>(unit));
}

TimeUnit time_unit(const std::vector<double>& times, std::optional<double> period_s) {
  const Numbers numbers = examine(times);
  if (const auto unit = epoch_unit(numbers)) return *unit;
  if (!(numbers.step > 0.0)) return TimeUnit::s;
  if (are_days(numbers, period_s)) return TimeUnit::day;
  TimeUnit best = TimeUnit::s;
  double lowest = std::numeric_limits<double>::infinity();
  for (const TimeUnit unit : {TimeUnit::s, TimeUnit::ms, TimeUnit::us, TimeUnit::ns, TimeUnit::cs}) {
    // Without a period nothing tells hundredths from the others.
    if (unit == TimeUnit::cs && !(period_s && numbers.whole)) continue;
    double apart = std::abs(std::log(numbers.step * seconds_in(unit) / period_s.value_or(default_period_s)));
    // Parts of a unit are written of seconds.
    if (!numbers.whole && unit == TimeUnit::s) apart -= 3.0;
    if (apart < lowest) {
      lowest = apart;
      best = unit;
    }
  }
  return best;
}

std::optional<TimeUnit> stated_time_unit(std::string_view text) {
  const std::string lower = config::lower_case(text);
  using Spelling = std::pair<std::string_view, TimeUnit>;
  constexpr std::array<Spelling, 34> spellings{{{"s", TimeUnit::s},
                                                {"sec", TimeUnit::s},
                                                {"secs", TimeUnit::s},
                                                {"second", TimeUnit::s},
                                                {"seconds", TimeUnit::s},
                                                {"cs", TimeUnit::cs},
                                                {"csec", TimeUnit::cs},
                                                {"centiseconds", TimeUnit::cs},
                                                {"hundredths", TimeUnit::cs},
                                                {"ms", TimeUnit::ms},
                                                {"msec", TimeUnit::ms},
                                                {"millis", TimeUnit::ms},
                                                {"millisecond", TimeUnit::ms},
                                                {"milliseconds", TimeUnit::ms},
                                                {"us", TimeUnit::us},
                                                {"\xc2\xb5s", TimeUnit::us},
                                                {"\xce\xbcs", TimeUnit::us},
                                                {"usec", TimeUnit::us},
                                                {"micros", TimeUnit::us},
                                                {"microsecond", TimeUnit::us},
                                                {"microseconds", TimeUnit::us},
                                                {"ns", TimeUnit::ns},
                                                {"nsec", TimeUnit::ns},
                                                {"nanos", TimeUnit::ns},
                                                {"nanosecond", TimeUnit::ns},
                                                {"nanoseconds", TimeUnit::ns},
                                                {"day", TimeUnit::day},
                                                {"days", TimeUnit::day},
                                                {"min", TimeUnit::min},
                                                {"minute", TimeUnit::min},
                                                {"minutes", TimeUnit::min},
                                                {"h", TimeUnit::h},
                                                {"hour", TimeUnit::h},
                                                {"hours", TimeUnit::h}}};
  const auto* const at = std::ranges::find(spellings, std::string_view(lower), &Spelling::first);
  return at == spellings.end() ? std::nullopt : std::optional(at->second);
}

bool is_plausible_unit(const std::vector<double>& times, TimeUnit unit) {
  const double step_s = examine(times).step * seconds_in(unit);
  return step_s >= 2e-4 && step_s <= 10.0;
}

double step_of_ms_or_cs(const std::vector<double>& times) {
  const Numbers numbers = examine(times);
  return numbers.whole && numbers.step >= 1.0 && numbers.step <= 20.0 ? numbers.step : 0.0;
}

std::vector<std::size_t> unwrap_clock(std::vector<double>& times) {
  constexpr double of_32_bits = 4294967296.0;
  std::vector<std::size_t> rows;
  const bool goes_back = std::ranges::adjacent_find(times, std::greater<>()) != times.end();
  const double step = goes_back ? examine(times).step : 0.0;
  if (!(step > 0.0)) return rows;
  for (const double modulus : {of_32_bits, of_32_bits * 1e-3, of_32_bits * 1e-6, 16777216.0, 65536.0}) {
    double offset = 0.0;
    double last = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (!std::isfinite(times[i])) continue;
      if (is_wrap(last, times[i], modulus, step)) {
        offset += modulus;
        rows.push_back(i);
      }
      last = times[i];
      times[i] += offset;
    }
    if (!rows.empty()) break;
  }
  return rows;
}

}  // namespace wheelwright::import

#include "tools/wheelwright/import/formats/text/time_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <utility>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/formats/text/line_cursor.hpp"

namespace wheelwright::import {
namespace {

using config::is_digit;
using config::to_lower;

bool starts_with_word(std::string_view text, std::string_view word) {
  return text.size() >= word.size() && std::ranges::equal(text.substr(0, word.size()), word, {}, to_lower);
}

// Takes what it reads off the front of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view rest) : rest_(rest) {}
  bool is_at_end() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

  bool take(char character) {
    if (rest_.empty() || rest_.front() != character) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool take_word(std::string_view word) {
    if (!starts_with_word(rest_, word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void skip_blanks() {
    while (take(' ') || take('\t')) {
    }
  }
  // Up to nine digits.
  std::optional<int> take_integer() {
    const std::size_t length = count_digits();
    if (length == 0 || length > 9) return std::nullopt;
    int value = 0;
    std::from_chars(rest_.data(), rest_.data() + length, value);
    rest_.remove_prefix(length);
    return value;
  }
  // What stands behind '.' or ','; 0 where nothing does.
  double take_decimals() {
    if (rest_.size() < 2 || (rest_.front() != '.' && rest_.front() != ',') || !is_digit(rest_[1])) return 0.0;
    rest_.remove_prefix(1);
    double value = 0.0;
    double weight = 1.0;
    for (; !rest_.empty() && is_digit(rest_.front()); rest_.remove_prefix(1)) {
      if (weight > 1e15) continue;
      weight *= 10.0;
      value = value * 10.0 + (rest_.front() - '0');
    }
    return value / weight;
  }
  std::size_t count_digits() const {
    const auto other = std::ranges::find_if_not(rest_, is_digit);
    return static_cast<std::size_t>(other - rest_.begin());
  }

 private:
  std::string_view rest_;
};

std::optional<bool> take_afternoon(Scanner& scanner) {
  Scanner ahead = scanner;
  ahead.skip_blanks();
  const bool is_afternoon = ahead.take_word("pm") || ahead.take_word("p.m.");
  if (!is_afternoon && !ahead.take_word("am") && !ahead.take_word("a.m.")) return std::nullopt;
  scanner = ahead;
  return is_afternoon;
}

// Two parts are minutes and seconds, but hours and minutes before AM or PM, or behind a date.
std::optional<double> take_clock(Scanner& scanner, bool is_behind_date) {
  const auto first = scanner.take_integer();
  if (!first || !scanner.take(':') || scanner.count_digits() > 2) return std::nullopt;
  const auto second = scanner.take_integer();
  if (!second || *second > 59) return std::nullopt;
  double hours = *first;
  double minutes = *second;
  double seconds = 0.0;
  bool has_hours = true;
  if (scanner.take(':')) {
    if (scanner.count_digits() > 2) return std::nullopt;
    const auto third = scanner.take_integer();
    if (!third || *third > 60) return std::nullopt;  // 60: a leap second
    seconds = *third + scanner.take_decimals();
  } else {
    has_hours = false;
    seconds = scanner.take_decimals();
  }
  const auto is_afternoon = take_afternoon(scanner);
  if (!has_hours && !is_afternoon && !is_behind_date) return *first * 60.0 + *second + seconds;
  if (is_afternoon) {
    if (*first < 1 || *first > 12) return std::nullopt;
    hours = *first % 12 + (*is_afternoon ? 12 : 0);
  }
  return hours * 3600.0 + minutes * 60.0 + seconds;
}

std::optional<int> take_month_name(Scanner& scanner) {
  constexpr std::array<std::string_view, 12> months{"jan", "feb", "mar", "apr", "may", "jun",
                                                    "jul", "aug", "sep", "oct", "nov", "dec"};
  for (std::size_t i = 0; i < months.size(); ++i) {
    if (scanner.take_word(months.at(i))) return static_cast<int>(i) + 1;
  }
  return std::nullopt;
}

struct Date {
  std::array<int, 3> parts{};  // as they stand there
  bool has_year_first = false;
  bool has_month_name = false;
};

std::optional<Date> take_date(Scanner& scanner) {
  Date date;
  date.has_year_first = scanner.count_digits() == 4;
  const auto first = scanner.take_integer();
  if (!first) return std::nullopt;
  char between = '\0';
  for (const char candidate : {'-', '/', '.'}) {
    if (between == '\0' && scanner.take(candidate)) between = candidate;
  }
  if (between == '\0') return std::nullopt;
  std::optional<int> second = take_month_name(scanner);
  date.has_month_name = second.has_value();
  if (!second && scanner.count_digits() <= 2) second = scanner.take_integer();
  if (!second || !scanner.take(between)) return std::nullopt;
  const std::size_t digits = scanner.count_digits();
  const auto third = scanner.take_integer();
  if (!third || digits != (date.has_year_first ? std::min<std::size_t>(digits, 2) : 4)) return std::nullopt;
  date.parts = {*first, *second, *third};
  return date;
}

std::optional<double> seconds_since_1970(const Date& date, DateOrder order, bool has_points) {
  int year = date.parts[2];
  int month = date.parts[1];
  int day = date.parts[0];
  if (date.has_year_first) {
    year = date.parts[0];
    day = date.parts[2];
  } else if (!date.has_month_name && !has_points && order == DateOrder::month_first) {
    std::swap(month, day);
  }
  const std::chrono::year_month_day calendar{std::chrono::year(year),
                                             std::chrono::month(static_cast<unsigned>(month)),
                                             std::chrono::day(static_cast<unsigned>(day))};
  if (!calendar.ok()) return std::nullopt;
  return 86400.0 * static_cast<double>(std::chrono::sys_days(calendar).time_since_epoch().count());
}

// Seconds that a zone is ahead of UTC.
std::optional<double> take_zone(Scanner& scanner) {
  scanner.skip_blanks();
  if (scanner.is_at_end() || scanner.take_word("utc") || scanner.take_word("gmt") || scanner.take_word("z"))
    return 0.0;
  const bool is_behind = scanner.take('-');
  if (!is_behind && !scanner.take('+')) return std::nullopt;
  const std::size_t digits = scanner.count_digits();
  const auto first = scanner.take_integer();
  if (!first || (digits != 2 && digits != 4)) return std::nullopt;
  int minutes = digits == 4 ? *first / 100 * 60 + *first % 100 : *first * 60;
  if (digits == 2 && scanner.take(':')) minutes += scanner.take_integer().value_or(0);
  return (is_behind ? -60.0 : 60.0) * minutes;
}

std::optional<TimeText> read_date_and_time(std::string_view text, DateOrder order) {
  Scanner scanner(text);
  const auto date = take_date(scanner);
  if (!date) return std::nullopt;
  const bool has_points = text.find('.') < text.size() - scanner.rest().size();
  const auto day = seconds_since_1970(*date, order, has_points);
  if (!day) return std::nullopt;
  if (scanner.is_at_end()) return TimeText{TimeForm::date, *day};
  if (!scanner.take('T') && !scanner.take('_')) scanner.skip_blanks();
  const auto clock = take_clock(scanner, true);
  if (!clock) return std::nullopt;
  const auto zone = take_zone(scanner);
  if (!zone || !scanner.is_at_end()) return std::nullopt;
  return TimeText{TimeForm::date_and_time, *day + *clock - *zone};
}

// "May  3 14:22:01.250", as syslog and journalctl write it: of no year, taken as 1972, which has a 29
// February.
std::optional<TimeText> read_syslog(std::string_view text) {
  Scanner scanner(text);
  const auto month = take_month_name(scanner);
  scanner.skip_blanks();
  const auto day = scanner.take_integer();
  scanner.skip_blanks();
  const auto clock = take_clock(scanner, true);
  if (!month || !day || !clock || !scanner.is_at_end()) return std::nullopt;
  const auto seconds = seconds_since_1970({{1972, *month, *day}, true, false}, DateOrder::day_first, false);
  if (!seconds) return std::nullopt;
  return TimeText{TimeForm::date_and_time, *seconds + *clock};
}

// The stamp that begins a line of syslog, with the machine and the program behind it.
std::optional<StampPrefix> syslog_prefix(std::string_view line) {
  Scanner scanner(line);
  if (!take_month_name(scanner)) return std::nullopt;
  scanner.skip_blanks();
  if (!scanner.take_integer()) return std::nullopt;
  scanner.skip_blanks();
  if (!take_clock(scanner, true)) return std::nullopt;
  const std::size_t length = line.size() - scanner.rest().size();
  if (!read_syslog(line.substr(0, length))) return std::nullopt;
  const auto program = line.find("]: ", length);
  const auto last_of_host = line.find_first_of("=:,;", length);
  const bool has_program = program != std::string_view::npos && program < last_of_host;
  return StampPrefix{line.substr(0, length), has_program ? program + 3 : length};
}

std::optional<TimeText> read_clock(std::string_view text) {
  Scanner scanner(text);
  double days = 0.0;
  Scanner ahead = scanner;
  if (const auto count = ahead.take_integer()) {
    ahead.skip_blanks();
    if (ahead.take_word("days") || ahead.take_word("day")) {
      ahead.take(',');
      ahead.skip_blanks();
      ahead.take('+');
      scanner = ahead;
      days = *count;
    }
  }
  const auto clock = take_clock(scanner, false);
  if (!clock || !scanner.is_at_end()) return std::nullopt;
  return TimeText{TimeForm::clock, days * 86400.0 + *clock};
}

}  // namespace

std::optional<TimeText> read_time(std::string_view text, DateOrder order) {
  if (text.size() < 4 || text.size() > 60) return std::nullopt;
  if (!is_digit(text.front())) return read_syslog(text);
  if (const auto clock = read_clock(text)) return clock;
  return read_date_and_time(text, order);
}

std::optional<DateOrder> order_shown_by(std::string_view text) {
  Scanner scanner(text);
  const auto date = take_date(scanner);
  if (!date || date->has_year_first || date->has_month_name) return std::nullopt;
  if (date->parts[0] > 12) return DateOrder::day_first;
  if (date->parts[1] > 12) return DateOrder::month_first;
  return std::nullopt;
}

std::optional<StampPrefix> stamp_prefix(std::string_view line) {
  constexpr std::size_t longest_prefix = 40;
  const std::string_view head = line.substr(0, longest_prefix);
  const auto matches = [](std::string_view stamp) {
    return read_time(stamp, DateOrder::day_first).has_value();
  };
  if (const auto arrow = head.find("->"); arrow != std::string_view::npos) {
    const std::string_view stamp = trim(head.substr(0, arrow));
    if (matches(stamp)) return StampPrefix{stamp, arrow + 2};
  }
  if (head.starts_with('[')) {
    const auto bracket = head.find(']');
    if (bracket == std::string_view::npos) return std::nullopt;
    const std::string_view stamp = trim(head.substr(1, bracket - 1));
    if (matches(stamp)) return StampPrefix{stamp, bracket + 1};
  }
  return syslog_prefix(line);
}

}  // namespace wheelwright::import

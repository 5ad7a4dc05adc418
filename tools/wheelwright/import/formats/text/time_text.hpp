// Times and dates that were written for people.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace wheelwright::import {

enum class TimeForm { clock, date, date_and_time };
enum class DateOrder { day_first, month_first };  // of 03/05/2024; 2024-05-03 needs none

struct TimeText {
  TimeForm form = TimeForm::clock;
  double seconds = 0.0;  // since midnight for a clock, since 1970 for a date; without a zone taken as UTC
};

// h:mm:ss.fff, mm:ss.fff, with AM or PM, with days before it ("0 days 00:00:01.5"); 2024-03-05, 5.3.2024,
// 3/5/2024, 05-Mar-2024; both parted by 'T' or blanks, with Z or +01:00; Mar  5 14:22:01 of a syslog.
// Decimals behind '.' or ','.
std::optional<TimeText> read_time(std::string_view text, DateOrder order);

// Whether a date such as 25/03/2024 or 03/25/2024 shows its order by a number above 12.
std::optional<DateOrder> order_shown_by(std::string_view text);

// The characters of "12:34:56.789 -> ", which the serial monitor of the Arduino IDE writes before a line,
// of "[12:34:56.789] ", or of "May  3 12:34:56 host program[812]: "; 0 where a line does not begin so.
struct StampPrefix {
  std::string_view stamp;
  std::size_t length = 0;  // with what parts it from the rest
};
std::optional<StampPrefix> stamp_prefix(std::string_view line);

}  // namespace wheelwright::import

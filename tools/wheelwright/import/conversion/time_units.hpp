// What the numbers of a time column stand for.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// How many seconds one unit of a time is; 1 of frames, whose rate is stated elsewhere.
double seconds_in(TimeUnit unit);

// "milliseconds".
std::string_view in_words(TimeUnit unit);

// The unit of a time column by its size and its steps: 1.7e12 is milliseconds since 1970, steps of 50 are
// milliseconds, 45356.5 with steps of a millionth is days. `period_s` is the period that the file states,
// where it does.
TimeUnit time_unit(const std::vector<double>& times, std::optional<double> period_s);

// The unit that a file states for its time ("ms", "usec", "hundredths"); nothing where it is none.
std::optional<TimeUnit> stated_time_unit(std::string_view text);

// Whether rows that are so far apart in a unit are at a rate at which robots are logged.
bool is_plausible_unit(const std::vector<double>& times, TimeUnit unit);

// The step of whole numbers that could be milliseconds of a fast log or hundredths of a second of a slow one;
// 0 where the steps leave no doubt.
double step_of_ms_or_cs(const std::vector<double>& times);

// A counter of time that starts again behind 2^32 (2^16, 2^24, or microseconds of 32 bits as milliseconds or
// seconds) goes on where it was. Returns the rows at which it starts again.
std::vector<std::size_t> unwrap_clock(std::vector<double>& times);

}  // namespace wheelwright::import

// How the values of a column go, whatever they are called.
#pragma once

#include <vector>

namespace wheelwright::import {

// Whether values rise at nearly every row by about the same: 0 never, 1 as a clock. Of a clock that was set
// and of rows out of order the most rise.
double evenness(const std::vector<double>& values);

// Whether each value is the one before and one more.
bool is_row_index(const std::vector<double>& values);

// Whether there are no parts of one.
bool are_whole(const std::vector<double>& values);

// Whether a column is held for most rows, as a command is, and changes at all.
bool is_held(const std::vector<double>& values);

// Whether values go by one most of the time, over a range: the counts of a slow wheel are held as a command
// is.
bool looks_counted(const std::vector<double>& values);

// The step between the values of a channel, where it has one: speeds that were counted.
double quantum(const std::vector<double>& values);

// Largest size of the values; 0 where there are none.
double largest(const std::vector<double>& values);

}  // namespace wheelwright::import

// Columns of a table that hold a time in parts.
#pragma once

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// A column of whole seconds and one of the nanoseconds beyond them ("stamp.sec" and "stamp.nanosec") become
// one, of seconds, with the name of the first.
void join_seconds_and_nanoseconds(Stream& stream);

// A column "dt" of a table without a time becomes one: the sum of its steps up to each row.
void sum_steps_of_time(Stream& stream);

}  // namespace wheelwright::import

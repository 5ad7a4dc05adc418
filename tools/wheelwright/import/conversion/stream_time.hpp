// When the rows of a stream were measured.
#pragma once

#include <optional>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording.hpp"

namespace wheelwright::import {

// The unit of a time column by its size and its steps: 1.7e12 is milliseconds since 1970, steps of 50 are
// milliseconds. `period_s` is the period that the file states, where it does.
TimeUnit time_unit(const std::vector<double>& times, std::optional<double> period_s);

// When each row of a stream was measured, in seconds: by the mapped column, else by stamps of its own that
// agree with the time of recording, else by that time, else by a column of its own that is named as a time,
// else by rows that are `period_s` apart. Empty where there is none.
std::vector<double> stream_times(const Stream& stream, const TimeMapping& time);

// A channel of a stream by its name, or by its number from 1; nullptr where it is none of the stream.
const Channel* channel_of(const Stream& stream, const std::string& name);
const Channel* channel_of(const Stream& stream, const ChannelName& name);

// A trajectory in the TUM format: t x y z qx qy qz qw, without names.
bool is_tum(const Stream& stream);

}  // namespace wheelwright::import

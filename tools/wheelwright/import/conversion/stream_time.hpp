// When the rows of a stream were measured.
#pragma once

#include <optional>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// The unit of a time column: as the file states it, where that gives a rate at which robots are logged, else
// by its numbers (time_units.hpp).
TimeUnit time_unit_of(const Stream& stream, const Channel& channel, std::optional<double> period_s);
// Whether a channel is the number of the frame or sample of each row, by its name and its values.
bool counts_frames(const Channel& channel);
std::optional<TimeUnit> time_unit_stated_for(const Stream& stream, const Channel& channel);

// The column that holds the time of a stream: the mapped one, else one that is named so; nullptr where the
// time is that of recording, or there is none.
const Channel* time_channel(const Stream& stream, const TimeMapping& time);

// When each row of a stream was measured, in seconds: by the mapped column, else by stamps of its own that
// agree with the time of recording, else by that time, else by a column of its own that is named as a time,
// else by frames or rows that are `period_s` apart. Empty where there is none.
std::vector<double> stream_times(const Stream& stream, const TimeMapping& time);

// A channel of a stream by its name, or by its number from 1; nullptr where it is none of the stream.
const Channel* channel_of(const Stream& stream, const std::string& name);
const Channel* channel_of(const Stream& stream, const ChannelName& name);

// Stamps of the sender, where a message has them; nullptr where it has none.
const Channel* stamps_of_sender(const Stream& stream);

// A trajectory in the TUM format: t x y z qx qy qz qw, without names.
bool is_tum(const Stream& stream);

}  // namespace wheelwright::import

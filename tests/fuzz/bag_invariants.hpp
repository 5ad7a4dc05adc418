// What holds of every recording of a bag, whatever its bytes.
#pragma once

#include <algorithm>

#include "tests/fuzz/fuzz_input.hpp"
#include "tools/wheelwright/import/formats/ros/ros_recording.hpp"

namespace wheelwright::fuzz {

inline void check_recording(const import::ReadResult& recording) {
  if (!recording) return must_hold(recording.error().starts_with("fuzz: "), "a refusal names the file");
  for (const import::Stream& stream : recording->streams) {
    must_hold(stream.channels.empty() || stream.received_s.size() == stream.rows, "each row has a time");
    must_hold(std::ranges::is_sorted(stream.received_s), "rows are in order of time");
    must_hold(stream.channels.empty() != stream.not_decoded.empty(),
              "channels, or a reason why there are none");
    for (const import::Channel& channel : stream.channels)
      must_hold(channel.values.size() == stream.rows, "a channel has a value for each row");
  }
}

}  // namespace wheelwright::fuzz

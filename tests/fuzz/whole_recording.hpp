// What holds of every recording that a reader makes, and of every refusal.
#pragma once

#include "tests/fuzz/fuzz_input.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::fuzz {

inline void check_recording(const import::ReadResult& result) {
  if (!result) {
    must_hold(!result.error().empty(), "a refusal says why");
    must_hold(result.error().find('\n') == std::string::npos, "a refusal is one line");
    return;
  }
  must_hold(!result->format.empty(), "the format is named");
  for (const auto& remark : result->remarks)
    must_hold(remark.find('\n') == std::string::npos, "a remark is one line");
  for (const import::Stream& stream : result->streams) {
    must_hold(!stream.channels.empty() || !stream.not_decoded.empty(), "a stream has channels, or a reason");
    must_hold(stream.places.empty() || stream.places.size() == stream.rows, "each row has its line");
    for (const import::Channel& channel : stream.channels) {
      must_hold(channel.values.size() == stream.rows, "a channel has a value for each row");
      must_hold(!channel.name.empty(), "a channel has a name");
    }
  }
}

}  // namespace wheelwright::fuzz

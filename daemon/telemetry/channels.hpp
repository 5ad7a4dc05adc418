// The channels of the live view: what is sent, under which topic, in which form.
//
// Topics with a schema of Foxglove's appear by themselves in the panels of Foxglove and Lichtblick; the
// others are plain JSON that any plot panel shows. Times are Unix time, everything else is SI, in the frame
// of the route.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace wheelwright::daemon::telemetry {

enum class ChannelId : std::uint32_t {
  pose = 1,      // that the robot steers by
  predicted,     // by the model, from commands alone
  odometry,      // by the encoders as they are
  filtered,      // by the hybrid filter
  transform,     // from the route's frame to the robot
  scene,         // route, checkpoints, ways driven, and how sure the filter is
  log,           // the daemon's messages
  wheels,        // command, and speed by model and by measurement, of each wheel
  light_bumper,  // the six signals, and bumps
  loop,          // how late the sensor loop woke up
  state,         // phase, stop, faults, checkpoints, battery
  truth,         // of a simulated robot, where live_view.truth names its file
};

struct Channel {
  ChannelId id;
  std::string_view topic;
  std::string_view schema_name;
  std::string_view schema;  // JSON Schema
};

constexpr std::size_t channel_count = 12;
const std::array<Channel, channel_count>& channels();

// The channel of a number that a client sent, or null.
const Channel* find_channel(std::uint32_t id);

// One message, made once and shared by all who want it.
struct Message {
  ChannelId channel{};
  std::uint64_t time_ns = 0;  // Unix time
  std::shared_ptr<const std::string> payload;
};

}  // namespace wheelwright::daemon::telemetry

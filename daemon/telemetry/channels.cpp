#include "daemon/telemetry/channels.hpp"

#include <algorithm>

#include "daemon/telemetry/schemas.hpp"

namespace wheelwright::daemon::telemetry {

const std::array<Channel, channel_count>& channels() {
  static const std::array<Channel, channel_count> all{{
      {ChannelId::pose, "/pose", "foxglove.PoseInFrame", schema::pose_in_frame()},
      {ChannelId::predicted, "/pose/model", "foxglove.PoseInFrame", schema::pose_in_frame()},
      {ChannelId::odometry, "/pose/odometry", "foxglove.PoseInFrame", schema::pose_in_frame()},
      {ChannelId::filtered, "/pose/hybrid", "foxglove.PoseInFrame", schema::pose_in_frame()},
      {ChannelId::transform, "/tf", "foxglove.FrameTransform", schema::frame_transform()},
      {ChannelId::scene, "/scene", "foxglove.SceneUpdate", schema::scene_update()},
      {ChannelId::log, "/log", "foxglove.Log", schema::log()},
      {ChannelId::wheels, "/wheels", "wheelwright.Wheels", schema::wheels()},
      {ChannelId::light_bumper, "/light_bumper", "wheelwright.LightBumper", schema::light_bumper()},
      {ChannelId::loop, "/loop", "wheelwright.Loop", schema::loop()},
      {ChannelId::state, "/state", "wheelwright.State", schema::state()},
      {ChannelId::truth, "/pose/truth", "foxglove.PoseInFrame", schema::pose_in_frame()},
  }};
  return all;
}

const Channel* find_channel(std::uint32_t id) {
  const auto& all = channels();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Channel& channel) {
    return static_cast<std::uint32_t>(channel.id) == id;
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace wheelwright::daemon::telemetry

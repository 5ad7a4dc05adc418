// Messages as `rostopic echo` and `ros2 topic echo` print them: YAML, a line "---" behind each.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import::ros {

// A stream of a row per message, whose channels are named as those of a bag ("pose.pose.position.x",
// "position[wheel_left]"; a stamp is in seconds), without covariances. Messages that cannot be read are left
// out with a remark. Nothing where none can.
std::optional<Stream> read_yaml_messages(std::string_view text, std::vector<std::string>& remarks);

}  // namespace wheelwright::import::ros

// The usual types of robots, for bags of ROS 2 that hold no definitions (rosbag2 writes them since Iron).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace wheelwright::import::ros {

// The definition of a type of ROS 2 with those of its parts, as a bag would hold it; nothing for another.
std::optional<std::string> known_definition(std::string_view type);

// The type of more than one field that has these in this order; of several the first in the list. Empty where
// none has.
std::string_view type_with_fields(std::span<const std::string> names);

}  // namespace wheelwright::import::ros

// The reference that the names and types of channels suggest.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/inference/named_channels.hpp"

namespace wheelwright::import {

// Poses of the stream that looks most like a measurement from outside of the robot, or a heading alone;
// `has_wheels`: the robot's own odometry is none beside them. Adds a line to `findings` where one of several
// was taken.
std::optional<ReferenceMapping> find_named_reference(std::span<const Recording> recordings,
                                                     const NamedChannels& named, bool has_wheels,
                                                     std::vector<std::string>& findings);

}  // namespace wheelwright::import

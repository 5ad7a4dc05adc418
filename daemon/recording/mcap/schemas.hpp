// JSON Schemas of the messages that recordings hold and that the live view shares. Those named foxglove.* are
// the well-known ones; tools go by their names. What a message does not know is absent or null.
#pragma once

#include <string>

namespace wheelwright::mcap {

std::string pose_in_frame_schema();
std::string frame_transform_schema();
std::string log_schema();
std::string wheels_schema();
std::string sensors_schema();
std::string covariance_schema();
std::string state_schema();

}  // namespace wheelwright::mcap

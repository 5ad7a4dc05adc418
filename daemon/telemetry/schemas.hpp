// JSON Schemas of the messages: of those that Foxglove has a name for, in its fields; of the project's own,
// with units in the names.
#pragma once

#include <string_view>

namespace wheelwright::daemon::telemetry::schema {

std::string_view pose_in_frame();    // foxglove.PoseInFrame
std::string_view frame_transform();  // foxglove.FrameTransform
std::string_view scene_update();     // foxglove.SceneUpdate
std::string_view log();              // foxglove.Log

std::string_view wheels();
std::string_view light_bumper();
std::string_view loop();
std::string_view state();

}  // namespace wheelwright::daemon::telemetry::schema

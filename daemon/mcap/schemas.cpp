#include "daemon/mcap/schemas.hpp"

namespace wheelwright::mcap {
namespace {

constexpr const char* vector3 =
    R"({"type":"object","title":"foxglove.Vector3","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}})";
constexpr const char* quaternion =
    R"({"type":"object","title":"foxglove.Quaternion","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"},"w":{"type":"number"}}})";
constexpr const char* time =
    R"({"type":"object","title":"time","properties":{"sec":{"type":"integer","minimum":0},"nsec":{"type":"integer","minimum":0,"maximum":999999999}}})";

std::string object(const std::string& title, const std::string& properties) {
  return R"({"type":"object","title":")" + title + R"(","properties":{)" + properties + "}}";
}

// A message: every one has its time.
std::string message(const std::string& title, const std::string& properties) {
  return object(title, R"("timestamp":)" + std::string(time) + "," + properties);
}

std::string property(const std::string& name, const std::string& type, const std::string& description = "") {
  return "\"" + name + R"(":{"type":")" + type + "\"" +
         (description.empty() ? "" : R"(,"description":")" + description + "\"") + "}";
}

std::string of_both_wheels(const std::string& start, const std::string& end, const std::string& type,
                           const std::string& description) {
  return property(start + "left" + end, type, description) + "," +
         property(start + "right" + end, type, description);
}

}  // namespace

std::string pose_in_frame_schema() {
  const std::string pose = object("foxglove.Pose", R"("position":)" + std::string(vector3) +
                                                       R"(,"orientation":)" + std::string(quaternion));
  return message("foxglove.PoseInFrame", property("frame_id", "string") + R"(,"pose":)" + pose);
}

std::string frame_transform_schema() {
  return message("foxglove.FrameTransform", property("parent_frame_id", "string") + "," +
                                                property("child_frame_id", "string") + R"(,"translation":)" +
                                                vector3 + R"(,"rotation":)" + quaternion);
}

std::string log_schema() {
  return message("foxglove.Log", property("level", "integer", "2 information, 3 warning") + "," +
                                     property("message", "string") + "," + property("name", "string") + "," +
                                     property("file", "string") + "," + property("line", "integer"));
}

std::string wheels_schema() {
  return message(
      "wheelwright.Wheels",
      of_both_wheels("command_", "_m_s", "number", "commanded wheel speed, m/s") + "," +
          of_both_wheels("predicted_", "_m_s", "number", "by the model, from commands alone, m/s") + "," +
          of_both_wheels("measured_", "_m_s", "number", "by the encoder, m/s") + "," +
          of_both_wheels("ticks_", "", "integer", "encoder count, unwrapped"));
}

std::string sensors_schema() {
  return message("wheelwright.Sensors",
                 property("battery_v", "number", "V") + "," +
                     property("gyro_z_rad_s", "number", "turn rate by a gyro, rad/s") + "," +
                     of_both_wheels("current_", "_a", "number", "motor current, A") +
                     R"(,"light_bumper":{"type":"array","description":"from left to right, 0 to 4095",)"
                     R"("items":{"type":"number"}},)" +
                     property("bump", "boolean") + "," + property("wheel_drop", "boolean") + "," +
                     property("cliff", "boolean") + "," +
                     property("overcurrents", "integer", "bits as in the Open Interface"));
}

std::string covariance_schema() {
  return message("wheelwright.Covariance",
                 R"("covariance":{"type":"array","description":"of x, y, theta of /pose/hybrid, row by row: )"
                 R"(m^2, m rad, rad^2","items":{"type":"number"}})");
}

std::string state_schema() {
  return message("wheelwright.State",
                 property("activity", "string", "what the robot is doing") + "," +
                     property("stop", "string", "why the wheels were put to rest") + "," +
                     property("checkpoints_visited", "integer") + "," +
                     property("model_version", "integer", "of the model that is driven by; 1 is the first") +
                     "," + property("discarded", "string", "wheel whose reading the filter did not use") +
                     "," + of_both_wheels("fault_", "", "string", "fault that lasts") + "," +
                     property("recalibration_due", "boolean"));
}

}  // namespace wheelwright::mcap

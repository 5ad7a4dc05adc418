#include "daemon/recording/mcap/schemas.hpp"

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
  const std::string wheel =
      object("wheel", property("command_m_s", "number", "commanded speed, m/s") + "," +
                          property("predicted_m_s", "number", "by the model, from commands alone, m/s") +
                          "," + property("measured_m_s", "number", "by the encoder, m/s") + "," +
                          property("ticks", "integer", "encoder count, unwrapped") + "," +
                          property("motor_current_a", "number", "A") + "," +
                          property("fault", "string", "fault of the encoder that lasts"));
  return message("wheelwright.Wheels", R"("left":)" + wheel + R"(,"right":)" + wheel);
}

std::string sensors_schema() {
  return message("wheelwright.Sensors",
                 property("battery_v", "number", "V") + "," +
                     property("gyro_z_rad_s", "number", "turn rate by a gyro, rad/s") +
                     R"(,"light_bumper":{"type":"array","description":"from left to right, 0 to 4095",)"
                     R"("items":{"type":"number"}},)" +
                     property("bump", "boolean") + "," + property("wheel_drop", "boolean") + "," +
                     property("cliff", "boolean") + "," +
                     property("overcurrents", "integer", "bits as in the Open Interface"));
}

std::string covariance_schema() {
  return message("wheelwright.Covariance",
                 R"("covariance":{"type":"array","description":"of x, y, theta of the pose, row by row: )"
                 R"(m^2, m rad, rad^2","items":{"type":"number"}})");
}

std::string state_schema() {
  return message("wheelwright.State",
                 property("robot", "string") + "," + property("run_s", "number", "since the run began, s") +
                     "," + property("activity", "string", "what the robot is doing") + "," +
                     property("repetition", "integer") + "," + property("armed", "boolean") + "," +
                     property("robot_answers", "boolean") + "," +
                     property("stop", "string", "why the wheels were put to rest") + "," +
                     property("pose_source", "string", "of the pose that steers") + "," +
                     property("route", "string") + "," + property("checkpoints", "integer", "of the route") +
                     "," + property("checkpoints_visited", "integer") + "," +
                     property("model_version", "integer", "of the model that is driven by; 1 is the first") +
                     "," + property("discarded", "string", "wheel whose reading the filter did not use") +
                     "," + property("recalibration_due", "boolean") + "," +
                     property("battery_v", "number", "V") + "," +
                     property("period_s", "number", "of the sensor loop, s") + "," +
                     property("dropped", "integer", "ticks that the live view has lost") + "," +
                     property("watchers", "integer", "clients of the live view") + "," +
                     property("result", "string", "how the run came out") + "," +
                     property("outcome", "string", "of a run that has finished, its figures in words"));
}

}  // namespace wheelwright::mcap

#include "daemon/recording/mcap/robot_recording.hpp"

#include <cmath>

#include "daemon/recording/mcap/schemas.hpp"

namespace wheelwright::mcap {
namespace {

// Levels of foxglove.Log.
constexpr int information = 2;
constexpr int warning = 3;

constexpr double route_frame_height_m = 0.0;
constexpr double longest_s = 1e10;  // that nanoseconds can count

void put_wheel(JsonObject& json, std::string_view key, const TickValues& tick, double WheelPair::*side,
               std::int64_t WheelTicks::*ticks_side, const std::string* fault) {
  json.open(key);
  if (tick.command_m_s) json.number("command_m_s", (*tick.command_m_s).*side);
  if (tick.predicted_m_s) json.number("predicted_m_s", (*tick.predicted_m_s).*side);
  if (tick.measured_m_s) json.number("measured_m_s", (*tick.measured_m_s).*side);
  if (tick.ticks) json.whole("ticks", (*tick.ticks).*ticks_side);
  if (tick.sensors && tick.sensors->motor_current_a) {
    json.number("motor_current_a", (*tick.sensors->motor_current_a).*side);
  }
  if (fault != nullptr && !fault->empty()) json.text("fault", *fault);
  json.close();
}

// A turn about the vertical axis.
void put_rotation(JsonObject& json, std::string_view key, double theta_rad) {
  json.open(key)
      .number("x", 0.0)
      .number("y", 0.0)
      .fine("z", std::sin(0.5 * theta_rad))
      .fine("w", std::cos(0.5 * theta_rad))
      .close();
}

void put_position(JsonObject& json, std::string_view key, const Pose& pose) {
  json.open(key).number("x", pose.x_m).number("y", pose.y_m).number("z", route_frame_height_m).close();
}

}  // namespace

SteeringPose steering_pose(std::string_view pose_source) {
  if (pose_source == "odometry") return SteeringPose::odometry;
  return pose_source == "hybrid" ? SteeringPose::hybrid : SteeringPose::model;
}

RobotRecording::Topics RobotRecording::add_topics(Writer& writer) {
  const auto pose = [&](const std::string& name) {
    return writer.add_channel("/pose/" + name, "foxglove.PoseInFrame", pose_in_frame_schema());
  };
  Topics topics{};
  topics.model = pose("model");
  topics.odometry = pose("odometry");
  topics.hybrid = pose("hybrid");
  topics.reference = pose("reference");
  topics.transform = writer.add_channel("/tf", "foxglove.FrameTransform", frame_transform_schema());
  topics.wheels = writer.add_channel("/wheels", "wheelwright.Wheels", wheels_schema());
  topics.sensors = writer.add_channel("/sensors", "wheelwright.Sensors", sensors_schema());
  topics.covariance = writer.add_channel("/hybrid/covariance", "wheelwright.Covariance", covariance_schema());
  topics.model_covariance =
      writer.add_channel("/model/covariance", "wheelwright.Covariance", covariance_schema());
  topics.state = writer.add_channel("/state", "wheelwright.State", state_schema());
  topics.log = writer.add_channel("/log", "foxglove.Log", log_schema());
  return topics;
}

RobotRecording::RobotRecording(Sink sink, const std::map<std::string, std::string>& metadata,
                               SteeringPose steering, const WriterOptions& options)
    : writer_(std::move(sink), metadata, options), topics_(add_topics(writer_)), steering_(steering) {}

void RobotRecording::add(const TickValues& tick) {
  if (!(tick.t_s >= 0.0 && tick.t_s < longest_s)) return;
  time_ns_ = static_cast<std::uint64_t>(std::llround(1e9 * tick.t_s));
  if (tick.state) add_state(*tick.state);
  if (!tick.events.empty()) say(warning, tick.events);
  add_pose(topics_.model, "route", tick.model);
  add_pose(topics_.odometry, "route", tick.odometry);
  add_pose(topics_.hybrid, "route", tick.hybrid);
  add_pose(topics_.reference, "reference", tick.reference);
  add_transform(tick);
  add_wheels(tick);
  if (tick.sensors && !tick.sensors->empty()) add_sensors(*tick.sensors);
  add_covariance(topics_.covariance, tick.covariance);
  add_covariance(topics_.model_covariance, tick.model_covariance);
}

void RobotRecording::add_pose(std::uint16_t channel, std::string_view frame,
                              const std::optional<Pose>& pose) {
  if (!pose) return;
  json_.begin().time("timestamp", time_ns_).text("frame_id", frame).open("pose");
  put_position(json_, "position", *pose);
  put_rotation(json_, "orientation", pose->theta_rad);
  writer_.add(channel, time_ns_, json_.close().end());
}

void RobotRecording::add_transform(const TickValues& tick) {
  const auto& steers = steering_ == SteeringPose::hybrid     ? tick.hybrid
                       : steering_ == SteeringPose::odometry ? tick.odometry
                                                             : tick.model;
  const auto& pose = steers ? steers : tick.odometry;
  if (!pose) return;
  json_.begin()
      .time("timestamp", time_ns_)
      .text("parent_frame_id", "route")
      .text("child_frame_id", "base_link");
  put_position(json_, "translation", *pose);
  put_rotation(json_, "rotation", pose->theta_rad);
  writer_.add(topics_.transform, time_ns_, json_.end());
}

void RobotRecording::add_wheels(const TickValues& tick) {
  if (!tick.command_m_s && !tick.predicted_m_s && !tick.measured_m_s && !tick.ticks) return;
  const auto fault = [&](std::string StateValues::*side) {
    return tick.state ? &((*tick.state).*side) : nullptr;
  };
  json_.begin().time("timestamp", time_ns_);
  put_wheel(json_, "left", tick, &WheelPair::left, &WheelTicks::left, fault(&StateValues::fault_left));
  put_wheel(json_, "right", tick, &WheelPair::right, &WheelTicks::right, fault(&StateValues::fault_right));
  writer_.add(topics_.wheels, time_ns_, json_.end());
}

void RobotRecording::add_sensors(const SensorValues& sensors) {
  json_.begin().time("timestamp", time_ns_);
  if (sensors.battery_v) json_.number("battery_v", *sensors.battery_v);
  if (sensors.gyro_z_rad_s) json_.number("gyro_z_rad_s", *sensors.gyro_z_rad_s);
  if (sensors.light_bumper) json_.array("light_bumper", *sensors.light_bumper);
  json_.flag("bump", sensors.bump).flag("wheel_drop", sensors.wheel_drop).flag("cliff", sensors.cliff);
  writer_.add(topics_.sensors, time_ns_, json_.whole("overcurrents", sensors.overcurrents).end());
}

void RobotRecording::add_covariance(std::uint16_t channel,
                                    const std::optional<std::array<double, 6>>& covariance) {
  if (!covariance) return;
  const auto& [xx, xy, yy, x_theta, y_theta, theta_theta] = *covariance;
  const std::array rows{xx, xy, x_theta, xy, yy, y_theta, x_theta, y_theta, theta_theta};
  json_.begin().time("timestamp", time_ns_).array("covariance", rows);
  writer_.add(channel, time_ns_, json_.end());
}

void RobotRecording::add_state(const StateValues& state) {
  if (last_state_ == state) return;
  const bool stopped = !state.stop.empty() && state.stop != "none";
  if (stopped && (!last_state_ || last_state_->stop != state.stop)) say(warning, "stopped: " + state.stop);
  if (!last_state_ || last_state_->activity != state.activity) say(information, state.activity);
  last_state_ = state;
  json_.begin()
      .time("timestamp", time_ns_)
      .text("activity", state.activity)
      .text("stop", state.stop)
      .whole("checkpoints_visited", state.checkpoints_visited)
      .whole("model_version", state.model_version)
      .text("discarded", state.discarded)
      .flag("recalibration_due", state.recalibration_due);
  writer_.add(topics_.state, time_ns_, json_.end());
}

void RobotRecording::say(int level, std::string_view message) {
  if (message.empty()) return;
  json_.begin()
      .time("timestamp", time_ns_)
      .whole("level", level)
      .text("message", message)
      .text("name", "wheelwright")
      .text("file", "")
      .whole("line", 0);
  writer_.add(topics_.log, time_ns_, json_.end());
}

}  // namespace wheelwright::mcap

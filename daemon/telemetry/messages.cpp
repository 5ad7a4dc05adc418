#include "daemon/telemetry/messages.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "daemon/telemetry/json_text.hpp"

namespace wheelwright::daemon::telemetry {
namespace {

// {"timestamp":...,  ready for what follows.
std::string stamped(std::uint64_t time_ns) {
  return R"({"timestamp":)" + time_text(time_ns);
}

std::string field(std::string_view name, const std::string& value) {
  return ",\"" + std::string(name) + "\":" + value;
}

std::string wheel_text(double command, double predicted, double measured, double current_a, FaultKind fault) {
  return R"({"command_m_s":)" + number(command, 4) + field("predicted_m_s", number(predicted, 4)) +
         field("measured_m_s", number(measured, 4)) + field("motor_current_a", number(current_a, 3)) +
         field("fault", json_quoted(name_of(fault))) + "}";
}

}  // namespace

std::string json_quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

const Pose& steering_pose(const PoseRecord& record, PoseSource source) {
  if (source == PoseSource::hybrid && record.hybrid) return record.hybrid->pose;
  return is_sensorless(source) && record.has_prediction ? record.predicted : record.odometry;
}

std::string pose_message(std::uint64_t time_ns, const Pose& pose) {
  return stamped(time_ns) + field("frame_id", json_quoted(route_frame)) + field("pose", pose_text(pose)) +
         "}";
}

std::string transform_message(std::uint64_t time_ns, const Pose& pose) {
  return stamped(time_ns) + field("parent_frame_id", json_quoted(route_frame)) +
         field("child_frame_id", json_quoted(robot_frame)) +
         field("translation", point_text(pose.x_m, pose.y_m)) + field("rotation", turn_text(pose.theta_rad)) +
         "}";
}

std::string wheels_message(std::uint64_t time_ns, const LogEntry& entry) {
  const SensorFrame& frame = entry.frame;
  const PoseRecord& record = entry.record;
  // Nothing is known of a speed that nobody predicted or measured.
  const double unknown = std::nan("");
  const WheelPair predicted =
      record.has_prediction ? record.predicted_speed_m_s : WheelPair{unknown, unknown};
  const WheelPair measured = frame.valid ? record.measured_speed_m_s : WheelPair{unknown, unknown};
  const WheelPair current = frame.valid ? frame.motor_current_a : WheelPair{unknown, unknown};
  const auto fault = [&](FaultKind HybridOutput::*side) {
    return record.hybrid ? (*record.hybrid).*side : FaultKind::none;
  };
  return stamped(time_ns) +
         field("left", wheel_text(frame.command.speed_m_s.left, predicted.left, measured.left, current.left,
                                  fault(&HybridOutput::left_fault))) +
         field("right", wheel_text(frame.command.speed_m_s.right, predicted.right, measured.right,
                                   current.right, fault(&HybridOutput::right_fault))) +
         "}";
}

std::string light_bumper_message(std::uint64_t time_ns, const SensorFrame& frame) {
  constexpr std::array<std::string_view, 6> names{"left",         "front_left",  "center_left",
                                                  "center_right", "front_right", "right"};
  std::string text = stamped(time_ns);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += field(names.at(i), std::to_string(frame.light_bumper.at(i)));
  }
  return text + field("bump_left", flag(frame.bump_left)) + field("bump_right", flag(frame.bump_right)) + "}";
}

std::string loop_message(std::uint64_t time_ns, double lateness_s) {
  return stamped(time_ns) + field("lateness_us", number(1e6 * lateness_s, 1)) + "}";
}

std::string state_message(std::uint64_t time_ns, const LogEntry& entry, const config::DaemonConfig& config,
                          const StepContext& step_context) {
  const SensorFrame& frame = entry.frame;
  const PoseRecord& record = entry.record;
  std::string text = stamped(time_ns) + field("robot", json_quoted(config.robot_name)) +
                     field("run_s", number(record.t_s, 3)) +
                     field("activity", json_quoted(name_of(frame.command.activity))) +
                     field("repetition", std::to_string(frame.command.repetition)) +
                     field("armed", flag(frame.armed)) +
                     field("robot_answers", flag(step_context.robot_answers)) +
                     field("stop", json_quoted(name_of(frame.stop))) +
                     field("pose_source", json_quoted(name_of(config.pose_source)));
  if (config.route) {
    text += field("route", json_quoted(config.route->name)) +
            field("checkpoints", std::to_string(config.route->checkpoints.size())) +
            field("checkpoints_visited", std::to_string(record.visited));
  }
  text += field("model_version", std::to_string(record.model_version)) +
          field("recalibration_due", flag(record.hybrid && record.hybrid->recalibration_due));
  if (frame.valid) text += field("battery_v", number(frame.battery_v, 2));
  return text + field("period_s", number(config.link.period_s, 6)) +
         field("dropped", std::to_string(step_context.dropped)) +
         field("watchers", std::to_string(step_context.watchers)) +
         field("result", json_quoted(step_context.result)) +
         field("outcome", json_quoted(step_context.outcome)) + "}";
}

std::string log_message(std::uint64_t time_ns, LogLevel level, std::string_view text) {
  return stamped(time_ns) + field("level", std::to_string(static_cast<int>(level))) +
         field("message", json_quoted(text)) + field("name", R"("wheelwrightd")") + field("file", R"("")") +
         field("line", "0") + "}";
}

}  // namespace wheelwright::daemon::telemetry

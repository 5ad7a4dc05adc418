#include "daemon/recording/mcap_log.hpp"

#include "config/load/text_format.hpp"
#include "daemon/recording/covariance_columns.hpp"
#include "daemon/recording/fault_text.hpp"

namespace wheelwright::daemon {
namespace {

constexpr auto chunk_every = std::chrono::seconds(1);

std::map<std::string, std::string> metadata_of(const config::DaemonConfig& config) {
  return {{"robot", config.robot_name},
          {"wheel_base_m", config::plain_number(config.limits.wheel_base_m)},
          {"period_s", config::plain_number(config.limits.period_s)},
          {"pose_source", std::string(name_of(config.pose_source))}};
}

// Creates the file on the way, so that the recording's first bytes find it open.
mcap::Sink sink_into(GrowingFile& file, const std::filesystem::path& path) {
  file.create(path, "");
  return [&file](std::string_view bytes) { return file.add(bytes); };
}

mcap::SensorValues sensors_of(const SensorFrame& frame) {
  mcap::SensorValues sensors;
  sensors.battery_v = frame.battery_v;
  sensors.motor_current_a = frame.motor_current_a;
  auto& light = sensors.light_bumper.emplace();
  for (std::size_t i = 0; i < light.size(); ++i) light.at(i) = frame.light_bumper.at(i);
  sensors.bump = frame.bump_left || frame.bump_right;
  sensors.wheel_drop = frame.wheel_drop;
  sensors.cliff = frame.cliff;
  sensors.overcurrents = frame.overcurrents;
  return sensors;
}

mcap::StateValues state_of(const LogEntry& entry) {
  const PoseRecord& record = entry.record;
  mcap::StateValues state;
  state.activity = name_of(entry.frame.command.activity);
  state.stop = name_of(entry.frame.stop);
  state.checkpoints_visited = record.visited;
  state.model_version = record.model_version;
  if (!record.hybrid) return state;
  const HybridOutput& hybrid = *record.hybrid;
  if (hybrid.left.discarded) state.discarded = hybrid.right.discarded ? "both" : "left";
  if (!hybrid.left.discarded && hybrid.right.discarded) state.discarded = "right";
  state.fault_left = name_of(hybrid.left_fault);
  state.fault_right = name_of(hybrid.right_fault);
  state.recalibration_due = hybrid.recalibration_due;
  return state;
}

}  // namespace

mcap::TickValues tick_values(const LogEntry& entry) {
  const SensorFrame& frame = entry.frame;
  const PoseRecord& record = entry.record;
  mcap::TickValues tick;
  tick.t_s = record.t_s;
  tick.command_m_s = frame.command.speed_m_s;
  tick.measured_m_s = record.measured_speed_m_s;
  tick.odometry = record.odometry;
  tick.state = state_of(entry);
  if (frame.valid) {
    tick.ticks = frame.counted_ticks;
    tick.sensors = sensors_of(frame);
  }
  if (record.has_prediction) {
    tick.model = record.predicted;
    tick.predicted_m_s = record.predicted_speed_m_s;
    tick.model_covariance = covariance_columns(record.predicted_covariance);
  }
  if (record.hybrid) {
    tick.hybrid = record.hybrid->pose;
    tick.covariance = covariance_columns(record.hybrid->covariance);
    tick.events = field_of(record.hybrid->events);
  }
  return tick;
}

McapLog::McapLog(const config::DaemonConfig& config, const std::filesystem::path& path)
    : recording_(sink_into(file_, path), metadata_of(config),
                 mcap::steering_pose(name_of(config.pose_source))) {}

void McapLog::flush(std::chrono::steady_clock::time_point now) {
  if (now >= next_chunk_) {
    recording_.end_chunk();
    next_chunk_ = now + chunk_every;
  }
  file_.flush(now);
}

std::uint64_t McapLog::close() {
  recording_.finish();
  file_.close();
  return recording_.lost_messages();
}

}  // namespace wheelwright::daemon

#include "daemon/replay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>

#include "daemon/log_format.hpp"
#include "daemon/plan.hpp"
#include "model/brain/brain.hpp"
#include "model/brain/calibrator.hpp"

namespace wheelwright::daemon {
namespace {

// Commands are logged with six decimals.
constexpr double same_command_m_s = 1e-6;

const ExtraColumn* column_or_none(const DriveLog& log, const std::string& name) {
  for (const ExtraColumn& column : log.extra_columns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

const ExtraColumn& column_of(const DriveLog& log, const std::string& name) {
  if (const ExtraColumn* column = column_or_none(log, name)) return *column;
  throw config::ConfigError(log.name + ": has no column '" + name +
                            "'; replay needs a drive log of the daemon");
}

// The rows of a log as the frames that the brain saw.
class RecordedFrames {
 public:
  explicit RecordedFrames(const DriveLog& log)
      : log_(log),
        tick_(column_of(log, "tick")),
        activity_(column_of(log, "activity")),
        stop_(column_of(log, "stop")),
        after_gap_(column_of(log, "after_gap")),
        wheel_drop_(column_of(log, "wheel_drop")),
        overcurrents_(column_of(log, "overcurrents")),
        current_left_(column_of(log, "current_left_a")),
        current_right_(column_of(log, "current_right_a")),
        doubtful_sign_(column_of(log, "doubtful_sign")),
        travel_left_(column_of(log, "travel_ticks_left")),
        travel_right_(column_of(log, "travel_ticks_right")),
        model_version_(column_or_none(log, "model_version")) {
    const std::array names{"light_left",         "light_front_left",  "light_center_left",
                           "light_center_right", "light_front_right", "light_right"};
    for (std::size_t s = 0; s < names.size(); ++s) light_.at(s) = &column_of(log, names.at(s));
  }

  std::size_t size() const { return log_.samples.size(); }
  std::int64_t tick(std::size_t row) const { return std::llround(tick_.values[row]); }
  const std::string& activity(std::size_t row) const { return activity_.texts[row]; }
  const WheelPair& command(std::size_t row) const { return log_.samples[row].command_m_s; }

  // Of the model that was driven by; 1 where the log is from before models were adapted.
  std::uint16_t model_version(std::size_t row) const {
    return model_version_ == nullptr ? std::uint16_t{1}
                                     : static_cast<std::uint16_t>(model_version_->values[row]);
  }

  // All but the command.
  SensorFrame frame(std::size_t row) const {
    SensorFrame frame;
    frame.tick = tick(row) + 1;  // the run starts one tick after it was armed
    frame.stop = stop_reason(row);
    frame.armed = frame.stop == StopReason::none;
    const DriveSample& sample = log_.samples[row];
    frame.valid = sample.ticks.has_value();
    if (!frame.valid) return frame;
    frame.ticks = travel(row);
    frame.after_gap = after_gap_.values[row] > 0.0;
    frame.doubtful_sign = doubtful_sign_.values[row] > 0.0;
    frame.wheel_drop = wheel_drop_.values[row] > 0.0;
    frame.overcurrents = static_cast<std::uint8_t>(overcurrents_.values[row]);
    frame.motor_current_a = {amperes(current_left_.values[row]), amperes(current_right_.values[row])};
    frame.battery_v = sample.battery_v.value_or(0.0);
    for (std::size_t s = 0; s < light_.size(); ++s) {
      frame.light_bumper.at(s) = static_cast<std::uint16_t>(light_.at(s)->values[row]);
    }
    return frame;
  }

  // The robot as it was armed, standing where the first row finds it.
  SensorFrame before_start() const {
    SensorFrame frame;
    frame.armed = true;
    for (std::size_t row = 0; row < size() && !frame.valid; ++row) {
      frame.valid = log_.samples[row].ticks.has_value();
      if (frame.valid) frame.ticks = travel(row);
    }
    return frame;
  }

 private:
  WheelTicks travel(std::size_t row) const {
    return {std::llround(travel_left_.values[row]), std::llround(travel_right_.values[row])};
  }

  // Of the milliamperes that the robot reports, by the same product as then.
  static double amperes(double logged) { return 1e-3 * std::round(1e3 * logged); }

  StopReason stop_reason(std::size_t row) const {
    for (int code = 0; code <= static_cast<int>(StopReason::requested); ++code) {
      const auto reason = static_cast<StopReason>(code);
      if (name_of(reason) == stop_.texts[row]) return reason;
    }
    throw config::ConfigError(log_.name + ":" + std::to_string(log_.first_line + row) + ": '" +
                              stop_.texts[row] + "' is no reason to stop that this version knows");
  }

  const DriveLog& log_;
  const ExtraColumn& tick_;
  const ExtraColumn& activity_;
  const ExtraColumn& stop_;
  const ExtraColumn& after_gap_;
  const ExtraColumn& wheel_drop_;
  const ExtraColumn& overcurrents_;
  const ExtraColumn& current_left_;
  const ExtraColumn& current_right_;
  const ExtraColumn& doubtful_sign_;
  const ExtraColumn& travel_left_;
  const ExtraColumn& travel_right_;
  const ExtraColumn* model_version_;
  std::array<const ExtraColumn*, 6> light_{};
};

class Replay {
 public:
  Replay(const DriveLog& log, const config::DaemonConfig& config, const Plan& plan)
      : config_(config),
        frames_(log),
        calibrator_(plan.mission, plan.limits, plan.model),
        brain_(plan.mission, plan.limits,
               plan.model ? std::make_unique<DrivingModel>(*plan.model) : nullptr) {}

  ReplayResult run() {
    result_.pose_log = pose_log_head(config_);
    brain_.take(frames_.before_start());
    collect_commands();
    for (std::size_t row = 0; row < frames_.size(); ++row) one_row(row);
    result_.ticks = frames_.size();
    return std::move(result_);
  }

 private:
  void one_row(std::size_t row) {
    LogEntry entry;
    entry.frame = frames_.frame(row);
    entry.frame.command = command_of(row, entry.frame);
    exchange_model(row, entry.frame.tick);
    entry.record = brain_.take(entry.frame);
    result_.pose_log += pose_log_line(entry, config_.limits.wheel_base_m) + "\n";
    if (auto outcome = calibrator_.take(entry.frame)) {
      (outcome->kind == CalibrationKind::adaptation ? adapted_ : waiting_) = std::move(outcome);
    }
    // A fit took some time then and takes another now: its outcome comes when the recorded run went on.
    const bool goes_on = row + 1 == frames_.size() || frames_.activity(row + 1) != frames_.activity(row);
    if (waiting_ && goes_on) deliver();
    collect_commands();
  }

  // Where it was exchanged then.
  void exchange_model(std::size_t row, std::int64_t tick) {
    const std::uint16_t version = frames_.model_version(row);
    if (version == model_version_) return;
    model_version_ = version;
    if (adapted_ && adapted_->adapted->version == version) {
      brain_.exchange_model(std::make_unique<DrivingModel>(*adapted_->model), tick, version);
    } else if (!result_.first_difference) {
      result_.first_difference = frames_.tick(row);
    }
    adapted_.reset();
  }

  Command command_of(std::size_t row, const SensorFrame& frame) {
    while (!commands_.empty() && commands_.front().tick < frame.tick) commands_.pop_front();
    const bool given = !commands_.empty() && commands_.front().tick == frame.tick;
    if (given && was_recorded(commands_.front(), row)) {
      last_command_ = commands_.front();
    } else if (frame.stop != StopReason::none && was_recorded({frame.tick, {}, Activity::stopped, 0}, row)) {
      last_command_ = {frame.tick, {}, Activity::stopped, 0};  // the link's own
    } else if (!was_recorded(last_command_, row) && !result_.first_difference) {
      // Where the command came too late the loop held the last one; anything else is another brain.
      result_.first_difference = frames_.tick(row);
    }
    last_command_.tick = frame.tick;
    return last_command_;
  }

  bool was_recorded(const Command& command, std::size_t row) const {
    const WheelPair& recorded = frames_.command(row);
    return std::abs(command.speed_m_s.left - recorded.left) < same_command_m_s &&
           std::abs(command.speed_m_s.right - recorded.right) < same_command_m_s &&
           name_of(command.activity) == frames_.activity(row);
  }

  void collect_commands() {
    const double limit = config_.link.largest_speed_m_s;
    while (auto command = brain_.next_command()) {
      // As the link does: rounding may have gone past it.
      command->speed_m_s.left = std::clamp(command->speed_m_s.left, -limit, limit);
      command->speed_m_s.right = std::clamp(command->speed_m_s.right, -limit, limit);
      commands_.push_back(*command);
    }
  }

  void deliver() {
    const CalibrationOutcome outcome = std::move(*waiting_);
    waiting_.reset();
    if (outcome.refusal) {
      brain_.refuse();
    } else if (outcome.kind == CalibrationKind::encoder_order) {
      brain_.accept_encoder_order();
    } else if (outcome.kind == CalibrationKind::encoder_scale) {
      brain_.accept_encoder_scale(outcome.encoder_scale->metres_per_tick);
    } else {
      brain_.accept_model(std::make_unique<DrivingModel>(*outcome.model));
    }
  }

  const config::DaemonConfig& config_;
  RecordedFrames frames_;
  Calibrator calibrator_;
  Brain brain_;
  std::deque<Command> commands_;
  Command last_command_;
  std::optional<CalibrationOutcome> waiting_;
  std::optional<CalibrationOutcome> adapted_;  // to be driven by where the log says so
  std::uint16_t model_version_ = 1;
  ReplayResult result_;
};

}  // namespace

ReplayResult replay(const DriveLog& log, const config::DaemonConfig& config,
                    const std::optional<RobotModel>& model) {
  return Replay(log, config, make_plan(config, model)).run();
}

}  // namespace wheelwright::daemon

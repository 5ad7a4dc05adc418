#include "daemon/replay/replay.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>

#include "daemon/recording/log_format.hpp"
#include "daemon/replay/recorded_frames.hpp"
#include "daemon/wiring/plan.hpp"
#include "model/brain/brain.hpp"
#include "model/brain/calibrator.hpp"

namespace wheelwright::daemon {
namespace {

// Commands are logged with six decimals.
constexpr double same_command_m_s = 1e-6;

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
    if (outcome.refusal || outcome.route_refusal) {
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

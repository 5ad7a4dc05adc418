#include "daemon/replay/virtual_run.hpp"

#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <utility>

#include "drivers/roomba/roomba_link.hpp"

namespace wheelwright::daemon {
namespace {

using std::chrono::nanoseconds;

// How often the host looks for bytes within a tick.
constexpr int looks_per_tick = 6;

RobotLimits limits_of(const VirtualRunConfig& config) {
  RobotLimits limits = config.limits;
  if (config.model && config.model->encoder_scale)
    limits.metres_per_tick = config.model->encoder_scale->metres_per_tick;
  return limits;
}

class VirtualRun {
 public:
  VirtualRun(const VirtualRunConfig& config, simulation::SimulatedRobot& robot)
      : config_(config),
        robot_(robot),
        link_(config.link),
        calibrator_(config.mission, limits_of(config), config.model),
        brain_(config.mission, limits_of(config),
               config.model ? std::make_unique<DrivingModel>(*config.model) : nullptr) {
    link_.port_opened();
  }

  VirtualRunResult run(const TickHook& hook) {
    const auto ticks = static_cast<std::int64_t>(config_.longest_s / config_.limits.period_s);
    for (std::int64_t tick = 0; tick < ticks && !over_; ++tick) {
      if (hook) hook(robot_, tick);
      one_tick(tick);
    }
    result_.stop = brain_.stop_reason();
    result_.replies = link_.reply_counts();
    result_.duration_s = std::chrono::duration<double>(robot_.now()).count();
    return std::move(result_);
  }

 private:
  void one_tick(std::int64_t tick) {
    if (link_.state() == roomba::LinkState::running && !asked_to_arm_) {
      link_.arm();
      asked_to_arm_ = true;
    }
    late_ = config_.host_lateness ? config_.host_lateness(tick) : nanoseconds{};
    robot_.advance(late_);
    send(link_.begin_tick(tick, static_cast<double>(tick) * config_.limits.period_s, command_for(tick)));
    const auto period = nanoseconds(static_cast<std::int64_t>(1e9 * config_.limits.period_s)) - late_;
    bool answered = false;
    for (int look = 0; look < looks_per_tick; ++look) {
      robot_.advance(period / looks_per_tick);
      std::array<std::uint8_t, 512> bytes{};
      const std::size_t count = robot_.transmit(bytes);
      for (std::size_t i = 0; i < count; ++i) {
        const auto reading = link_.receive(bytes.at(i));
        if (!reading || answered) continue;
        answered = true;
        finish_tick(&*reading);
      }
    }
    robot_.advance(period - looks_per_tick * (period / looks_per_tick));
    if (!answered) finish_tick(nullptr);
  }

  void finish_tick(const open_interface::Reading* reading) {
    SensorFrame frame = link_.complete_tick(reading);
    frame.late_us = static_cast<std::int32_t>(late_ / std::chrono::microseconds(1));
    send(link_.urgent_bytes());
    result_.frames.push_back(frame);
    result_.records.push_back(brain_.take(frame));
    if (const StopReason reason = brain_.wanted_stop(); reason != StopReason::none) link_.stop(reason);
    result_.true_poses.push_back(robot_.truth().pose);
    if (auto outcome = calibrator_.take(frame)) deliver(*outcome);
    while (const auto command = brain_.next_command()) commands_.push_back(*command);
    note_route_start(frame);
    const bool stands_finished = frame.command.activity == Activity::finished;
    const bool stopped = brain_.stop_reason() != StopReason::none;
    ticks_after_end_ += stands_finished || stopped ? 1 : 0;
    result_.finished = result_.finished || stands_finished;
    over_ = ticks_after_end_ > 40;
  }

  void note_route_start(const SensorFrame& frame) {
    if (frame.command.activity == Activity::route && !result_.true_pose_at_route_start) {
      result_.true_pose_at_route_start = robot_.truth().pose;
    }
  }

  void deliver(CalibrationOutcome& outcome) {
    if (outcome.refusal) {
      result_.refusal = outcome.refusal;
      brain_.refuse();
      link_.stop(StopReason::refused);
      return;
    }
    if (outcome.route_refusal) {
      result_.refusal = outcome.route_refusal;
      brain_.refuse();
      link_.stop(StopReason::refused);
    }
    if (outcome.remark) result_.remarks.push_back(*outcome.remark);
    switch (outcome.kind) {
      case CalibrationKind::encoder_order:
        result_.encoders_swapped = outcome.encoders_swapped;
        if (outcome.encoders_swapped) {
          const bool left_first = link_.config().encoder_order == roomba::EncoderOrder::left_is_43;
          link_.set_encoder_order(left_first ? roomba::EncoderOrder::right_is_43
                                             : roomba::EncoderOrder::left_is_43);
        }
        brain_.accept_encoder_order();
        break;
      case CalibrationKind::encoder_scale:
        result_.encoder_scale = outcome.encoder_scale;
        brain_.accept_encoder_scale(outcome.encoder_scale->metres_per_tick);
        break;
      case CalibrationKind::response:
      case CalibrationKind::arma:
        if (outcome.response) result_.response = outcome.response;
        result_.arma = outcome.arma;
        result_.model = outcome.model;
        brain_.accept_model(std::make_unique<DrivingModel>(*outcome.model));
        break;
      case CalibrationKind::adaptation:
        result_.adapted.push_back(*outcome.model);
        brain_.exchange_model(std::make_unique<DrivingModel>(*outcome.model), outcome.adapted->from_tick,
                              outcome.adapted->version);
        break;
    }
  }

  std::optional<Command> command_for(std::int64_t tick) {
    while (!commands_.empty() && (commands_.front().tick < tick || !link_.armed())) commands_.pop_front();
    if (commands_.empty() || commands_.front().tick != tick) return std::nullopt;
    const Command command = commands_.front();
    commands_.pop_front();
    return command;
  }

  void send(std::span<const std::uint8_t> bytes) {
    if (!bytes.empty()) robot_.receive(bytes);
  }

  const VirtualRunConfig& config_;
  simulation::SimulatedRobot& robot_;
  roomba::RoombaLink link_;
  Calibrator calibrator_;
  Brain brain_;
  std::deque<Command> commands_;
  VirtualRunResult result_;
  bool asked_to_arm_ = false;
  nanoseconds late_{};
  int ticks_after_end_ = 0;
  bool over_ = false;
};

}  // namespace

VirtualRunResult run_virtually(const VirtualRunConfig& config, simulation::SimulatedRobot& robot,
                               const TickHook& hook) {
  return VirtualRun(config, robot).run(hook);
}

std::optional<double> true_closure_m(const VirtualRunResult& result) {
  if (!result.true_pose_at_route_start || result.true_poses.empty()) return std::nullopt;
  return distance_between_m(*result.true_pose_at_route_start, result.true_poses.back());
}

}  // namespace wheelwright::daemon

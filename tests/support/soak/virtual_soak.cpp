#include "tests/support/soak/virtual_soak.hpp"

#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <span>

#include "drivers/roomba/reopen_schedule.hpp"
#include "drivers/roomba/roomba_link.hpp"
#include "drivers/simulation/faulty_cable.hpp"
#include "drivers/simulation/simulated_robot.hpp"
#include "model/brain/brain.hpp"
#include "tests/support/soak/order_watch.hpp"
#include "tests/support/soak/rest_watch.hpp"
#include "tests/support/soak/sample_check.hpp"

namespace wheelwright::soak {
namespace {

using simulation::Direction;
using simulation::Nanoseconds;

constexpr Nanoseconds look{1'000'000};
constexpr double aftermath_s = 0.06;      // three ticks: what a fault hit may arrive so late
constexpr double operator_waits_s = 0.3;  // after the link has come back
constexpr double patience_s = 5.0;        // then the operator takes the battery out
constexpr double hopeless_s = 10.0;
constexpr double longest_half_command_s = 0.5;  // a robot may wait for 512 bytes of data

double seconds(Nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

// A robot whose wheels follow within 0.13 s.
RobotModel model_of(const simulation::GroundTruth& truth, double period_s) {
  RobotModel model;
  model.linear_part.period_s = period_s;
  model.linear_part.wheel_base_m = truth.wheel_base_m;
  model.linear_part.left.from_left = {0.0, 0.1, 0.2, 0.3, 0.2, 0.1, 0.1};
  model.linear_part.left.from_right.assign(7, 0.0);
  model.linear_part.right.from_left.assign(7, 0.0);
  model.linear_part.right.from_right = model.linear_part.left.from_left;
  model.encoder_scale =
      EncoderScale{{truth.metres_per_tick_left, truth.metres_per_tick_right}, 1660.0, 0.002};
  return model;
}

Mission mission() {
  Mission mission;
  mission.route = Route{"soak", 0.2, 0.03, {{0.6, 0.0}, {0.6, 0.6}, {0.0, 0.0}}};
  mission.pose_source = PoseSource::hybrid;
  return mission;
}

RobotLimits limits(const RobotModel& model, double period_s) {
  RobotLimits limits;
  limits.period_s = period_s;
  limits.metres_per_tick = model.encoder_scale->metres_per_tick;
  return limits;
}

class VirtualSoak {
 public:
  explicit VirtualSoak(const SoakConfig& config)
      : config_(config),
        robot_(config.robot),
        cable_(config.cable),
        link_(config.link),
        model_(model_of(robot_.truth(), config.link.period_s)),
        brain_(mission(), limits(model_, config.link.period_s), std::make_unique<DrivingModel>(model_)),
        reopening_(config.link.period_s) {
    robot_.set_host_baud(config.robot.link.baud);
    link_.port_opened();
  }

  SoakFigures run() {
    while (finished_faults_ < config_.faults || link_.state() != roomba::LinkState::running) {
      if (finished_faults_ >= config_.faults) cable_.let_be();
      one_tick();
    }
    close_fault();
    const auto& replies = link_.reply_counts();
    figures_.asked = static_cast<std::int64_t>(replies.asked);
    figures_.sound = static_cast<std::int64_t>(replies.sound);
    figures_.missing = static_cast<std::int64_t>(replies.missing);
    figures_.incomplete = static_cast<std::int64_t>(replies.incomplete);
    figures_.garbled = static_cast<std::int64_t>(replies.garbled);
    figures_.duration_s = seconds(robot_.now());
    rest_.report(figures_);
    return figures_;
  }

 private:
  double now_s() const { return seconds(robot_.now()); }

  void one_tick() {
    ++tick_;
    look_after_port();
    operate();
    const std::int64_t bad_before = bad_replies();
    send(link_.begin_tick(tick_, now_s(), command_for(tick_)));
    const Nanoseconds end = robot_.now() + simulation::nanoseconds(config_.link.period_s);
    answered_ = false;
    while (robot_.now() < end) move_on(std::min(look, end - robot_.now()));
    if (!answered_) finish_tick(nullptr);
    note_lost(bad_replies() - bad_before);
    link_was_starting_ = link_.state() != roomba::LinkState::running;
  }

  void note_lost(std::int64_t count) {
    if (count == 0 || hit_lately() || link_was_starting_) return;
    if (robot_is_away()) {
      figures_.lost_while_away += count;
    } else if (now_s() - last_deaf_s_ < longest_half_command_s) {
      figures_.lost_in_half_commands += count;
    } else {
      figures_.lost_outside += count;
    }
  }

  // Damaged bytes have sent it to boot or to sleep, or made it talk at another speed.
  bool robot_is_away() {
    const auto truth = robot_.truth();
    return truth.asleep || truth.baud != config_.robot.link.baud || booted_at_s_;
  }

  void move_on(Nanoseconds step) {
    robot_.advance(step);
    const auto truth = robot_.truth();
    left_.note_true(truth.counts_left);
    right_.note_true(truth.counts_right);
    figures_.driven_m += std::abs(truth.v_m_s) * seconds(step);
    if (truth.boots != boots_so_far_) booted_at_s_ = now_s();
    boots_so_far_ = truth.boots;
    follow_fault(truth);
    carry();
    rest_.look(now_s(), truth.wheels_at_rest, link_.armed(), hears());
  }

  // Whether what is said now reaches the robot as it is said.
  bool hears() {
    const auto fault = cable_.active(robot_.now());
    return link_.state() != roomba::LinkState::closed && !(fault && fault->to_robot) &&
           now_s() - last_fault_end_s_ > aftermath_s;
  }

  void carry() {
    std::array<std::uint8_t, 512> bytes{};
    const Nanoseconds now = robot_.now();
    while (const std::size_t count = robot_.transmit(bytes)) {
      cable_.put(Direction::to_host, std::span(bytes).first(count), now);
    }
    while (const std::size_t count = cable_.take(Direction::to_robot, bytes, now)) {
      robot_.receive(std::span(bytes).first(count));
    }
    while (const std::size_t count = cable_.take(Direction::to_host, bytes, now)) {
      if (link_.state() == roomba::LinkState::closed) continue;  // nobody listens
      for (std::size_t i = 0; i < count; ++i) {
        const auto reading = link_.receive(bytes.at(i));
        if (reading && !answered_) finish_tick(&*reading);
      }
    }
  }

  void send(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return;
    const std::int64_t moving = said_.orders().moving;
    said_.take(bytes);
    if (!link_.armed()) figures_.moving_orders_disarmed += said_.orders().moving - moving;
    cable_.put(Direction::to_robot, bytes, robot_.now());
  }

  void finish_tick(const open_interface::Reading* reading) {
    answered_ = true;
    const StopReason stop_before = link_.stop_reason();
    const SensorFrame frame = link_.complete_tick(reading);
    send(link_.urgent_bytes());
    if (reading != nullptr) note_sound_reading();
    if (frame.valid) check_sample(frame);
    if (link_.stop_reason() != stop_before && link_.stop_reason() != StopReason::none) note_stop();
    brain_.take(frame);
    while (const auto command = brain_.next_command()) commands_.push_back(*command);
  }

  void check_sample(const SensorFrame& frame) {
    if (frame.after_gap) {
      left_.new_origin();
      right_.new_origin();
    }
    if (hit_lately()) {
      // Judged, but not believed.
      SampleCheck left = left_;
      SampleCheck right = right_;
      if (!left.agrees(frame.counted_ticks.left) || !right.agrees(frame.counted_ticks.right)) {
        ++figures_.wrong_in_faults;
      }
      return;
    }
    const bool left_agrees = left_.agrees(frame.counted_ticks.left);
    const bool right_agrees = right_.agrees(frame.counted_ticks.right);
    if (!left_agrees || !right_agrees) {
      ++figures_.wrong_outside;
      left_.new_origin();
      right_.new_origin();
    }
  }

  std::optional<Command> command_for(std::int64_t tick) {
    while (!commands_.empty() && (commands_.front().tick < tick || !link_.armed())) commands_.pop_front();
    if (commands_.empty() || commands_.front().tick != tick) return std::nullopt;
    return commands_.front();
  }

  // What the sensor loop does with a port (drivers/roomba/sensor_loop.cpp).
  void look_after_port() {
    using roomba::LinkState;
    const bool there = cable_.connected(robot_.now());
    if ((!there || link_.state() == LinkState::lost) && link_.state() != LinkState::closed) {
      link_.stop(StopReason::link_lost);
      link_.port_closed();
      reopening_.closed(tick_);
      note_stop();
    } else if (link_.state() == LinkState::closed && reopening_.due(tick_)) {
      there ? link_.port_opened() : reopening_.failed(tick_);
    }
  }

  void operate() {
    const bool running = link_.state() == roomba::LinkState::running;
    const double since_fault_s = now_s() - last_fault_end_s_;
    const bool quiet = !cable_.active(robot_.now()) && since_fault_s > operator_waits_s;
    if (running && quiet && now_s() - armed_at_s_ > 1.5 &&
        (!link_.armed() || brain_.activity() == Activity::finished)) {
      link_.arm();
      armed_at_s_ = now_s();
    }
    if (quiet && now_s() - last_sound_s_ > patience_s && !battery_out_) help_robot();
  }

  // The battery out and in again, where nothing that the host can say would help.
  void help_robot() {
    const auto truth = robot_.truth();
    if (!truth.asleep && truth.baud == config_.robot.link.baud) return;
    robot_.inject({.kind = simulation::Fault::Kind::power_off});
    robot_.inject({.kind = simulation::Fault::Kind::power_on});
    battery_out_ = true;
    recovering_since_s_ = now_s();
  }

  void follow_fault(const simulation::GroundTruth& truth) {
    const auto fault = cable_.active(robot_.now());
    while (const auto record = cable_.next_finished()) {
      ++finished_faults_;
      last_fault_end_s_ = now_s();
      last_hit_s_ = now_s() + (record->fault.kind == simulation::CableFaultKind::delay ||
                                       record->fault.kind == simulation::CableFaultKind::jitter
                                   ? record->fault.amount
                                   : 0.0);
      if (record->fault.to_robot) last_deaf_s_ = now_s();
      open_fault_->record = *record;
      recovering_since_s_ = now_s();
      rest_.link_returned(now_s(), truth.wheels_at_rest);
      if (config_.progress) config_.progress(finished_faults_);
    }
    const bool begun = fault && (!open_fault_ || open_fault_->from != fault->from);
    if (begun) {
      close_fault();
      open_fault_ = OpenFault{fault->from, bad_replies(), 0, {.fault = *fault}};
    }
    if (recovering_since_s_ && now_s() - *recovering_since_s_ > hopeless_s) {
      ++figures_.failed_recoveries;
      recovering_since_s_.reset();
    }
  }

  // The fault before is over, and so is what came of it.
  void close_fault() {
    if (!open_fault_) return;
    auto& kind = figures_.kinds.at(static_cast<std::size_t>(open_fault_->record.fault.kind));
    ++kind.injected;
    if (open_fault_->stops > 0) {
      ++kind.stopped_run;
    } else if (bad_replies() > open_fault_->bad_before) {
      ++kind.cost_samples;
    } else if (open_fault_->record.bytes_hit + open_fault_->record.bytes_added > 0) {
      ++kind.unnoticed;
    } else {
      ++kind.idle;
    }
    open_fault_.reset();
  }

  void note_stop() {
    ++figures_.stops[link_.stop_reason()];
    if (open_fault_) ++open_fault_->stops;
  }

  void note_sound_reading() {
    rest_.sound_reading(now_s());
    // What it said before it booted may still be on its way.
    const bool booted = booted_at_s_.has_value();
    const double listens_since_s = booted ? *booted_at_s_ + config_.robot.link.boot_time_s : 0.0;
    if (now_s() >= listens_since_s) booted_at_s_.reset();
    last_sound_s_ = now_s();
    if (!recovering_since_s_ || now_s() < listens_since_s) return;
    const double took_s = now_s() - std::max(*recovering_since_s_, listens_since_s);
    if (battery_out_) {
      ++figures_.switched_off_and_on;
    } else {
      Recovery& recovery = booted ? figures_.recovery_of_reset_robot : figures_.recovery;
      ++recovery.count;
      recovery.within_1_s += took_s <= 1.0 ? 1 : 0;
      recovery.longest_s = std::max(recovery.longest_s, took_s);
    }
    recovering_since_s_.reset();
    battery_out_ = false;
  }

  bool hit_lately() { return cable_.active(robot_.now()) || now_s() - last_hit_s_ < aftermath_s; }

  std::int64_t bad_replies() const {
    const auto& replies = link_.reply_counts();
    return static_cast<std::int64_t>(replies.missing + replies.incomplete + replies.garbled);
  }

  struct OpenFault {
    Nanoseconds from;
    std::int64_t bad_before = 0;
    int stops = 0;
    simulation::CableFaultRecord record;
  };

  const SoakConfig& config_;
  simulation::SimulatedRobot robot_;
  simulation::FaultyCable cable_;
  roomba::RoombaLink link_;
  RobotModel model_;
  Brain brain_;
  roomba::ReopenSchedule reopening_;
  std::deque<Command> commands_;
  OrderWatch said_;
  SampleCheck left_;
  SampleCheck right_;
  RestWatch rest_{config_.link.blind_limit_s + config_.link.period_s};
  SoakFigures figures_;
  std::int64_t tick_ = -1;
  bool answered_ = false;
  bool link_was_starting_ = true;
  bool battery_out_ = false;
  std::int64_t finished_faults_ = 0;
  std::optional<OpenFault> open_fault_;
  std::optional<double> recovering_since_s_;
  double last_fault_end_s_ = -1.0;
  double last_hit_s_ = -1.0;
  double last_deaf_s_ = -1.0;  // a fault that hit what the host sends was over
  double armed_at_s_ = -2.0;
  double last_sound_s_ = 0.0;
  int boots_so_far_ = 0;
  std::optional<double> booted_at_s_;  // and has not answered since
};

}  // namespace

SoakFigures run_virtual_soak(const SoakConfig& config) {
  return VirtualSoak(config).run();
}

}  // namespace wheelwright::soak

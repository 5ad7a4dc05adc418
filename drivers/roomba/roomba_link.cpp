#include "drivers/roomba/roomba_link.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "drivers/roomba/rest_bytes.hpp"
#include "drivers/roomba/stop_reason.hpp"

namespace wheelwright::roomba {
namespace {

using open_interface::Reading;

constexpr std::uint8_t passive = 1;
constexpr std::uint8_t safe = 2;

constexpr int start_settles_ticks = 3;  // the robot wants 20 ms after a change of mode
constexpr int start_again_ticks = 50;   // a robot that was just switched on misses the first Start
constexpr int ask_again_ticks = 10;
constexpr int revive_ticks = 4;
constexpr int readings_to_believe = 4;
constexpr double arming_patience_s = 1.0;

// No Roomba moves faster than 0.5 m/s, 1125 ticks/s; some room for slipping wheels and for sensor refreshes
// that fall between polls.
constexpr double max_ticks_per_s = 1600.0;
constexpr double refresh_slack_s = 0.04;
constexpr int implausible_before_new_origin = 3;
constexpr int standing_ticks_to_trust = 4;

}  // namespace

std::string_view name_of(LinkState state) {
  switch (state) {
    case LinkState::closed:
      return "closed";
    case LinkState::starting:
      return "starting";
    case LinkState::running:
      return "running";
    case LinkState::lost:
      return "lost";
  }
  return "unknown";
}

RoombaLink::RoombaLink(const LinkConfig& config) : config_(config), unarmed_motion_(config.period_s) {}

int RoombaLink::ticks_of(double seconds) const {
  return static_cast<int>(std::ceil(seconds / config_.period_s - 1e-9));
}

void RoombaLink::port_opened() {
  state_ = LinkState::starting;
  arm_state_ = ArmState::disarmed;
  ticks_since_open_ = 0;
  mode_offset_ = 0;
  asked_for_mode_ = false;
  says_safe_unasked_ = 0;
  urgent_.clear();
  counts_.stuck_bits = 0;
  begin_after_counter_reset();
}

void RoombaLink::port_closed() {
  state_ = LinkState::closed;
  arm_state_ = ArmState::disarmed;
}

void RoombaLink::arm() {
  stop_ = StopReason::none;
  arm_state_ = ArmState::asking;
  asking_since_tick_ = frame_.tick;
  late_in_a_row_ = 0;
}

void RoombaLink::stop(StopReason reason) {
  if (stop_ == StopReason::none) stop_ = reason;
  arm_state_ = ArmState::disarmed;
  urgent_.clear();
  add_drive(urgent_, {});
}

void RoombaLink::set_encoder_order(EncoderOrder order) {
  if (order == config_.encoder_order) return;
  config_.encoder_order = order;
  first_counter_.forget_signs();
  second_counter_.forget_signs();
  after_gap_ = true;  // what was the left total is the right one now
}

void RoombaLink::begin_after_counter_reset() {
  first_counter_.rebase();
  second_counter_.rebase();
  first_bits_.forget();
  second_bits_.forget();
  after_gap_ = true;
}

std::span<const std::uint8_t> RoombaLink::urgent_bytes() {
  out_ = urgent_;
  urgent_.clear();
  return out_.bytes();
}

std::span<const std::uint8_t> RoombaLink::farewell_bytes() {
  out_.clear();
  add_drive(out_, {});
  out_.start();
  out_.stop_oi();
  return out_.bytes();
}

open_interface::StrayText& RoombaLink::stray_text() {
  return config_.transport == Transport::query ? query_.stray_text() : stream_.stray_text();
}

bool RoombaLink::stands() const {
  const WheelPair& speed = frame_.command.speed_m_s;
  return speed.left == 0.0 && speed.right == 0.0 && standing_ticks_ >= standing_ticks_to_trust;
}

Command RoombaLink::applied_command(const std::optional<Command>& command) {
  Command obeyed;
  if (command && std::isfinite(command->speed_m_s.left) && std::isfinite(command->speed_m_s.right)) {
    obeyed = *command;
    late_in_a_row_ = 0;
  } else if (armed()) {
    // A tick without a reply ends as the next one begins, which leaves no time for a command: that is not
    // late, and how long it may go on is the blind limit's matter.
    if (!last_reply_failed_) {
      ++counts_.late_commands;
      if (++late_in_a_row_ > config_.late_commands_held) stop(StopReason::late_command);
    }
    obeyed = last_command_;
  }
  if (!armed()) {
    obeyed.speed_m_s = {};
    if (stop_ != StopReason::none) obeyed.activity = Activity::stopped;
  }
  const double limit = config_.largest_speed_m_s;
  obeyed.speed_m_s.left = std::clamp(obeyed.speed_m_s.left, -limit, limit);
  obeyed.speed_m_s.right = std::clamp(obeyed.speed_m_s.right, -limit, limit);
  return obeyed;
}

void RoombaLink::add_drive(open_interface::CommandBytes& out, const WheelPair& speed_m_s) const {
  if (config_.drive_mode == DriveMode::direct) {
    out.drive_direct(static_cast<int>(std::lround(1000.0 * speed_m_s.right)),
                     static_cast<int>(std::lround(1000.0 * speed_m_s.left)));
  } else {
    const double duty = 255.0 / config_.pwm_full_scale_m_s;
    out.drive_pwm(static_cast<int>(std::lround(duty * speed_m_s.right)),
                  static_cast<int>(std::lround(duty * speed_m_s.left)));
  }
}

std::span<const std::uint8_t> RoombaLink::begin_tick(std::int64_t tick, double host_time_s,
                                                     const std::optional<Command>& command) {
  last_command_ = frame_.command;
  out_.clear();
  const Command obeyed = applied_command(command);
  frame_ = SensorFrame{};
  frame_.tick = tick;
  frame_.t_s = static_cast<double>(tick) * config_.period_s;
  frame_.host_time_s = host_time_s;
  frame_.command = obeyed;
  frame_.command.tick = tick;
  if (state_ != LinkState::closed) write_tick_commands();
  return out_.bytes();
}

void RoombaLink::write_tick_commands() {
  handshake();
  if (state_ == LinkState::running && in_doubt_of_passive()) out_.start();
  if (arm_state_ == ArmState::asking) ask_for_mode();
  if (arm_state_ != ArmState::disarmed) {
    add_drive(out_, frame_.command.speed_m_s);
  } else if (stop_ != StopReason::none) {
    add_drive(out_, {});
  }
  if (config_.transport == Transport::stream && state_ == LinkState::running) revive_stream();
  if (config_.transport == Transport::query && ticks_since_open_ > start_settles_ticks) {
    // A damaged bit turns a query into the order to stream the same packets, which then garble the replies.
    if (last_reply_failed_) out_.pause_stream();
    out_.query_list(query_.begin());
  }
  ++ticks_since_open_;
}

// A damaged order may have ended the stream or made it one of other packets. Start goes in front for the
// reason that handshake() gives; it also ends the driving mode, so the wheels are given time to be stopped.
void RoombaLink::revive_stream() {
  const auto ticks_at_rest =
      frame_.tick - last_sound_tick_ - ticks_of(config_.blind_limit_s + longest_braking_s);
  if (ticks_at_rest < 0 || ticks_at_rest % revive_ticks != 0) return;
  out_.start();
  out_.stream(stream_.packets());
}

bool RoombaLink::in_doubt_of_passive() const {
  return says_safe_unasked_ > 0 && says_safe_unasked_ < readings_to_believe;
}

// Not before the robot has said what it calls Passive.
void RoombaLink::ask_for_mode() {
  if (state_ != LinkState::running || in_doubt_of_passive()) {
    asking_since_tick_ = frame_.tick;
    return;
  }
  asked_for_mode_ = true;
  config_.full_mode ? out_.full_mode() : out_.safe_mode();
}

// What is asked for holds a 7, the number of the bump sensors. To a robot in Off mode that is Reset: one that
// has just booted would be sent to boot again, for ever. So Start goes right in front, at first only in some
// of the attempts, later in nearly all; the others leave the robot time between Start and question.
void RoombaLink::handshake() {
  if (state_ == LinkState::running) return;
  const auto step = ticks_since_open_ % start_again_ticks;
  const auto attempt = static_cast<std::uint64_t>(ticks_since_open_ / start_again_ticks);
  const bool start_in_front = !std::has_single_bit(attempt + 1);
  if (step == 0) {
    out_.padding(padding_bytes);
    add_drive(out_, {});
    out_.start();
    out_.pause_stream();  // that another program may have left running
  } else if (start_in_front) {
    out_.start();
  }
  // Often, since a damaged request is answered by nothing.
  const bool asks_for_stream = step % ask_again_ticks == start_settles_ticks;
  if (asks_for_stream && config_.transport == Transport::stream) out_.stream(stream_.packets());
}

std::optional<Reading> RoombaLink::receive(std::uint8_t byte) {
  return config_.transport == Transport::query ? query_.take(byte) : stream_.take(byte);
}

SensorFrame RoombaLink::complete_tick(const Reading* reading) {
  last_reply_failed_ = reading == nullptr;
  if (reading != nullptr) {
    take_reading(*reading, frame_);
  } else {
    note_silence();
  }
  frame_.stop = stop_;
  frame_.armed = armed();
  return frame_;
}

void RoombaLink::note_silence() {
  if (state_ != LinkState::running) return;
  const auto silent_ticks = frame_.tick - last_sound_tick_;
  if (armed() && silent_ticks >= ticks_of(config_.blind_limit_s)) stop(StopReason::blind);
  if (silent_ticks < ticks_of(config_.lost_after_s)) return;
  stop(StopReason::link_lost);
  state_ = LinkState::lost;
  ++counts_.times_lost;
}

void RoombaLink::take_reading(const Reading& reading, SensorFrame& frame) {
  last_reading_ = reading;
  frame.light_bumper = reading.light_bumper;
  frame.bump_right = (reading.bumps_and_wheel_drops & 1U) != 0;
  frame.bump_left = (reading.bumps_and_wheel_drops & 2U) != 0;
  frame.wheel_drop = (reading.bumps_and_wheel_drops & 12U) != 0;
  frame.cliff = reading.cliff;
  frame.overcurrents = reading.overcurrents;
  frame.oi_mode = reading.oi_mode;
  frame.charging_state = reading.charging_state;
  frame.battery_v = 1e-3 * reading.voltage_mv;
  frame.battery_a = 1e-3 * reading.current_ma;
  frame.motor_current_a = {1e-3 * reading.left_motor_ma, 1e-3 * reading.right_motor_ma};
  frame.valid = true;
  take_counts(reading, frame);
  if (state_ == LinkState::starting) state_ = LinkState::running;
  last_sound_tick_ = frame.tick;
  // A wheel drop or cliff also ends Safe mode: the cause is told, not the consequence.
  const StopReason danger = stop_reason_in(reading, config_.lowest_battery_v);
  if (arm_state_ != ArmState::disarmed && danger != StopReason::none) stop(danger);
  follow_mode(reading.oi_mode);
}

void RoombaLink::take_counts(const Reading& reading, SensorFrame& frame) {
  const double elapsed_s =
      static_cast<double>(frame.tick - last_sound_tick_) * config_.period_s + refresh_slack_s;
  const int max_change = static_cast<int>(std::min(max_ticks_per_s * elapsed_s, 30000.0));
  const bool left_first = config_.encoder_order == EncoderOrder::left_is_43;
  const double first_command = left_first ? last_command_.speed_m_s.left : last_command_.speed_m_s.right;
  const double second_command = left_first ? last_command_.speed_m_s.right : last_command_.speed_m_s.left;
  const WheelTicks before{first_counter_.total(), second_counter_.total()};
  const WheelTicks counted_before{first_counter_.counted(), second_counter_.counted()};
  const bool first_taken = first_counter_.update(reading.left_counts, first_command, max_change);
  const bool second_taken = second_counter_.update(reading.right_counts, second_command, max_change);
  const bool turned = first_counter_.total() != before.left || second_counter_.total() != before.right;
  standing_ticks_ = turned ? 0 : standing_ticks_ + 1;
  const std::int64_t ticks = std::max(std::abs(first_counter_.counted() - counted_before.left),
                                      std::abs(second_counter_.counted() - counted_before.right));
  if (unarmed_motion_.take(arm_state_ != ArmState::disarmed, ticks)) ++counts_.times_moved_unarmed;
  if (first_taken && second_taken) {
    implausible_in_a_row_ = 0;
    note_counter_bits(reading, counted_before);
  } else {
    ++counts_.implausible;
    frame.valid = false;
    standing_ticks_ = 0;
    if (++implausible_in_a_row_ >= implausible_before_new_origin) {
      begin_after_counter_reset();
    }
  }
  if (counts_.stuck_bits != 0) frame.valid = false;
  const auto& left = left_first ? first_counter_ : second_counter_;
  const auto& right = left_first ? second_counter_ : first_counter_;
  frame.counted_ticks = {left.counted(), right.counted()};
  frame.ticks = {left.total(), right.total()};
  frame.doubtful_sign = left.doubtful() || right.doubtful();
  if (frame.valid) {
    frame.after_gap = after_gap_;
    after_gap_ = false;
  }
}

// Of such counts none is right, although each fits the one before.
void RoombaLink::note_counter_bits(const Reading& reading, const WheelTicks& counted_before) {
  first_bits_.take(reading.left_counts, static_cast<int>(first_counter_.counted() - counted_before.left));
  second_bits_.take(reading.right_counts, static_cast<int>(second_counter_.counted() - counted_before.right));
  counts_.stuck_bits |= first_bits_.stuck() | second_bits_.stuck();
  if (counts_.stuck_bits != 0 && arm_state_ != ArmState::disarmed) stop(StopReason::blind);
}

void RoombaLink::follow_mode(std::uint8_t reported_mode) {
  // After Start the robot is in Passive; one that then says Safe counts its modes from one. So does one that
  // a Start has not reached: it is told again, and believed only when it keeps saying so.
  if (!asked_for_mode_) {
    const bool says_safe = reported_mode == passive + 1;
    says_safe_unasked_ = says_safe ? std::min(says_safe_unasked_ + 1, readings_to_believe) : 0;
    mode_offset_ = says_safe_unasked_ == readings_to_believe ? 1 : 0;
  }
  const bool obeys = asked_for_mode_ && reported_mode >= safe + mode_offset_;
  if (arm_state_ == ArmState::asking) {
    if (obeys) {
      arm_state_ = ArmState::armed;
    } else if (frame_.tick - asking_since_tick_ > ticks_of(arming_patience_s)) {
      stop(StopReason::mode_changed);
    }
  } else if (armed() && !obeys) {
    stop(StopReason::mode_changed);
  }
}

}  // namespace wheelwright::roomba

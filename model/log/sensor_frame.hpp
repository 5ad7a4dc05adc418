// What the sensor loop hands on each tick, and what it is told in return.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "model/geometry/pose.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright {

// What the robot is doing at a tick; the tag travels with the command and comes back in the frame.
enum class Activity : std::uint8_t {
  idle,
  wait_until_still,
  encoder_check,        // one wheel, to see which counter moves
  await_encoder_order,  // standing while the calibrator works
  encoder_turn,         // turning in place past the surroundings
  await_encoder_scale,
  left_on,  // the four response actions (calibration B of the source paper)
  left_off,
  right_on,
  right_off,
  await_response,
  random_drive,  // of the ARMA calibration (calibration C of the source paper)
  await_arma,
  route,
  commanded_drive,  // commands as they stand (model/brain/commanded_drive.hpp)
  finished,
  stopped,
};
std::string_view name_of(Activity activity);

// Why the wheels were put to rest although the plan had more.
enum class StopReason : std::uint8_t {
  none,
  bump,
  cliff,
  wheel_drop,
  overcurrent,
  mode_changed,  // the robot left Safe or Full mode by itself
  low_battery,
  charging,  // on the dock or plugged in
  blind,     // no valid sensor reading for longer than configured
  link_lost,
  late_command,  // nobody said in time what to do
  stalled,       // the sensor loop itself stood still, and the wheels were stopped for it
  refused,       // a calibration was not possible
  requested,     // by the user
  held,          // a wheel does not turn although its motor pulls
  lost_count,    // an encoder that the route is steered by counts no more
  other_period,  // the robot streams at another period than is configured
};
inline constexpr StopReason last_stop_reason = StopReason::other_period;
std::string_view name_of(StopReason reason);

constexpr std::int32_t largest_late_us = 10'000'000;  // that a frame states

// What to do at one tick.
struct Command {
  std::int64_t tick = 0;
  WheelPair speed_m_s;  // in force from this tick on
  Activity activity = Activity::idle;
  std::uint16_t repetition = 0;  // of a calibration action, from 0
};

// Reading of the six light-bumper sensors from left to right, 0 (dark) to 4095.
using LightBumper = std::array<std::uint16_t, 6>;

// One tick as it was.
struct SensorFrame {
  std::int64_t tick = 0;
  double t_s = 0.0;                    // tick times period, since the start of the run
  double host_time_s = 0.0;            // monotonic clock at the start of the tick
  Command command;                     // sent to the robot at this tick
  StopReason stop = StopReason::none;  // latched until the run is armed again
  bool armed = false;                  // the robot is in a mode that obeys and the loop sends motion

  bool valid = false;          // the reply of this tick came and was sound; what follows is from it
  std::int32_t late_us = 0;    // how late the tick began or, where that is more, the reply came
  bool after_gap = false;      // the first sound reply after a lost link: counts have a new origin
  WheelTicks counted_ticks;    // unwrapped, with the robot's own signs
  WheelTicks ticks;            // unwrapped, signed by the true direction as far as that can be known
  bool doubtful_sign = false;  // a wheel was coasting through a change of direction
  LightBumper light_bumper{};
  bool bump_left = false;
  bool bump_right = false;
  bool wheel_drop = false;
  bool cliff = false;
  std::uint8_t overcurrents = 0;
  std::uint8_t oi_mode = 0;
  std::uint8_t charging_state = 0;
  double battery_v = 0.0;
  double battery_a = 0.0;
  WheelPair motor_current_a;
};

}  // namespace wheelwright

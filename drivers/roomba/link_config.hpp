// How to talk to one robot, and when to stop it.
#pragma once

#include <chrono>
#include <cstdint>

#include "model/geometry/sensor_period.hpp"

namespace wheelwright::roomba {

enum class Transport : std::uint8_t {
  query,   // the host asks once a tick
  stream,  // the robot sends on its own period, and its frames are the tick
};

enum class DriveMode : std::uint8_t {
  direct,  // Drive Direct: the robot's speed controller is on
  pwm,     // Drive PWM: it is off, and commands are duty
};

enum class EncoderOrder : std::uint8_t {
  left_is_43,   // Create 2 document and page 35 of the 500 specification
  right_is_43,  // page 26 of the 500 specification
};

struct LinkConfig {
  double period_s = default_period_s;
  Transport transport = Transport::query;
  DriveMode drive_mode = DriveMode::direct;
  bool full_mode = false;  // Safe mode otherwise: the robot itself stops at a cliff or wheel drop
  EncoderOrder encoder_order = EncoderOrder::left_is_43;
  double largest_speed_m_s = 0.3;   // commands are limited to this
  double pwm_full_scale_m_s = 0.5;  // command at which the duty is 255
  double blind_limit_s = 0.25;      // without a sound reading for longer, the wheels are stopped
  double lost_after_s = 1.0;        // without a sound reading for longer, the port is opened again
  double lowest_battery_v = 12.0;
  int late_commands_held = 3;  // ticks with a reply for which the last command stays where none came in time
};

}  // namespace wheelwright::roomba

// What puts a robot's wheels to rest whatever was sent to it before.
#pragma once

#include "drivers/open_interface/commands.hpp"
#include "drivers/roomba/link_config.hpp"

namespace wheelwright::roomba {

// Longer than any command that this project sends.
inline constexpr std::size_t padding_bytes = 40;

// Ends whatever command was half sent, then orders both wheels to stand. Harmless in every mode, and as often
// as one likes.
inline open_interface::CommandBytes rest_bytes(DriveMode mode) {
  open_interface::CommandBytes out;
  out.padding(padding_bytes);
  mode == DriveMode::direct ? out.drive_direct(0, 0) : out.drive_pwm(0, 0);
  return out;
}

// The time that a robot gets to brake, which it does in Safe and Full mode only: one that is sent to Passive
// before rolls on for half a second. Old motors may creep for up to a second.
inline constexpr double longest_braking_s = 0.6;

}  // namespace wheelwright::roomba

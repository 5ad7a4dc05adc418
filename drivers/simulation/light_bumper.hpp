// The six infrared distance sensors along the front of the robot (packets 46 to 51, bits in packet 45).
#pragma once

#include <array>
#include <cstdint>

#include "drivers/simulation/chassis.hpp"
#include "drivers/simulation/noise.hpp"
#include "drivers/simulation/room.hpp"
#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class LightBumper {
 public:
  static constexpr std::size_t sensors =
      6;  // left, front left, centre left, centre right, front right, right

  explicit LightBumper(const LightBumperConfig& config) : config_(config) {}

  // What the sensors see now: 0 to 4095, more where something is nearer.
  std::array<std::int32_t, sensors> look(const Chassis& body, const Room& room, Noise& noise) const;

  // Packet 45 for such signals.
  std::int32_t bits(const std::array<std::int32_t, sensors>& signals) const;

 private:
  double echo(const Chassis& body, const Room& room, double mount_rad, double beam_rad) const;
  LightBumperConfig config_;
};

}  // namespace wheelwright::simulation

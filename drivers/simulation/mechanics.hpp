// Everything of the simulated robot that moves: battery, drive units, body, room, counters, on one clock.
#pragma once

#include "drivers/simulation/battery.hpp"
#include "drivers/simulation/chassis.hpp"
#include "drivers/simulation/drive_unit.hpp"
#include "drivers/simulation/encoder.hpp"
#include "drivers/simulation/fault.hpp"
#include "drivers/simulation/noise.hpp"
#include "drivers/simulation/room.hpp"
#include "drivers/simulation/simulation_config.hpp"
#include "drivers/simulation/wheel_controller.hpp"

namespace wheelwright::simulation {

// One drive motor, its wheel, and the firmware that looks after them.
struct DriveSide {
  DriveUnit unit;
  WheelController controller;
  Encoder encoder;
  bool lifted = false;
};

class Mechanics {
 public:
  // Draws the spread of the start pose from `noise`.
  Mechanics(const SimulationConfig& config, Noise& noise);

  void step(double duration_s);  // physics
  void controller_tick();        // firmware

  void command_speeds(double left_m_s, double right_m_s);
  void command_duties(double left, double right);
  void stop_motors();  // at once, by taking the voltage away

  // Applies what concerns the mechanics; the rest (power, buttons) is left to others.
  void inject(const Fault& fault);

  const DriveSide& left() const { return left_; }
  const DriveSide& right() const { return right_; }
  const Chassis& chassis() const { return chassis_; }
  const Room& room() const { return room_; }
  const Battery& battery() const { return battery_; }
  bool hangs(Side side) const;  // wheel-drop switch: lifted, or over a cliff
  double kinetic_energy_j() const;

 private:
  void count(DriveSide& side);

  ChassisConfig chassis_config_;
  Room room_;
  Battery battery_;
  DriveSide left_;
  DriveSide right_;
  Chassis chassis_;
};

}  // namespace wheelwright::simulation

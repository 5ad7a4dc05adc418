#pragma once

#include "tests/benchmark/fifth_plant/encoders.hpp"
#include "tests/benchmark/fifth_plant/firmware.hpp"
#include "tests/benchmark/fifth_plant/surroundings.hpp"
#include "tests/benchmark/fifth_plant/wheel.hpp"

namespace plants::fifth {

// One run of a robot, in fine steps of forces and torques.
class Vehicle {
 public:
  Vehicle(const Robot& robot, const Pose& start, double battery_v, const Random& random);

  void step(const PerWheel<double>& command_m_s);

  [[nodiscard]] const BodyMotion& motion() const { return motion_; }
  [[nodiscard]] PerWheel<long> ticks() const { return encoders_.ticks(); }
  [[nodiscard]] double battery_v() const { return battery_v_; }
  [[nodiscard]] PerWheel<double> wheel_rad_s() const;
  // Of the body and all that turns with the wheels.
  [[nodiscard]] double kinetic_energy_j() const;

 private:
  Wrench context(const Wrench& tyres);
  void move(const Wrench& sum);
  void discharge();

  Robot robot_;
  Pose start_;
  Firmware firmware_;
  PerWheel<Wheel> wheels_;
  Contact sideways_;
  Castor castor_;
  SlidingLoad load_;
  Turret turret_;
  Encoders encoders_;
  BodyMotion motion_;
  double rested_v_;
  double battery_v_;
};

}  // namespace plants::fifth

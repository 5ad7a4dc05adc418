// One wheel's way from the command to the force on the rim: radio, firmware, speed controller, amplifier,
// motor.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "tests/support/gap_plant/gear.hpp"
#include "tests/support/gap_plant/plant_parameters.hpp"

namespace wheelwright::test {

// Forces are in m/s: the steady speed that they give a wheel without a controller.
class WheelDrive {
 public:
  // `hour` of the day and `phase_rad` of the wheel's gear at the start of the run.
  WheelDrive(const PlantParameters& robot, double motor_gain, double dt_s, double hour, double phase_rad,
             std::uint64_t seed);

  // `command` as sent now, `other_command` that of the other wheel, `supply` the battery's voltage over its
  // nominal one.
  double force_m_s(double command, double other_command, double supply, double rim_speed_m_s, double rim_m);

  // Travel of the wheel for a travel of the motor.
  double wheel_m(double motor_m);

 private:
  double received(double command, double other_command);
  double amplified(double wanted, double supply);
  double motor_force(double drive, double speed) const;
  double losses(double speed, double rim_m);

  const PlantParameters robot_;
  double motor_gain_;
  double dt_s_;
  double phase_rad_;
  double cogging_;
  std::vector<double> in_flight_;  // commands on their way, a ring
  std::size_t next_ = 0;
  double integral_m_ = 0.0;
  double slewed_ = 0.0;
  double lagged_ = 0.0;
  double history_ = 0.0;
  double time_s_ = 0.0;
  double unsteady_ = 0.0;
  LuGreFriction friction_;
  HystereticSpring spring_;
  Play play_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace wheelwright::test

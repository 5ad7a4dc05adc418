#pragma once

#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// What shakes the robot: a load on each motor, noise of each voltage, and a floor that is not quite even.
class Shaking {
 public:
  Shaking(const Robot& robot, const Random& random);

  // To be called once in a millisecond.
  void step();
  [[nodiscard]] double load_n(std::size_t side) const;
  [[nodiscard]] double voltage_n(std::size_t side) const;
  [[nodiscard]] double forward_m_s() const { return forward_m_s_; }
  [[nodiscard]] double turn_rad_s() const { return turn_rad_s_; }

 private:
  void forget_and_draw(double& value, const NoiseSpec& spec);

  NoiseSpecs spec_;
  double yield_n_s_m_;
  double motor_n_s_m_;
  Random random_;
  PerWheel<double> fast_m_s_{};
  PerWheel<double> slow_m_s_{};
  PerWheel<double> voltage_m_s_{};
  double turn_rad_s_ = 0.0;
  double forward_m_s_ = 0.0;
};

}  // namespace plants::sixth

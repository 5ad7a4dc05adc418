#pragma once

#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// From commands to the duties of the bridge, in metres per second.
class Firmware {
 public:
  Firmware(const Robot& robot, const Hidden& hidden) : robot_(robot), hidden_(hidden) {}

  PerWheel<double> step(double time_s, const PerWheel<double>& command_m_s);

 private:
  void doze(double time_s, const PerWheel<double>& command_m_s);
  [[nodiscard]] double steepest_m_s2(const PerWheel<double>& command_m_s) const;
  double smoothed(std::size_t side, double time_s, double wanted_m_s, double steepest_m_s2);
  double through_bridge(std::size_t side, double duty_m_s);

  const Robot& robot_;
  const Hidden& hidden_;
  PerWheel<double> ramped_m_s_{};
  PerWheel<double> smoothed_m_s_{};
  PerWheel<bool> weak_{};
  double rested_s_ = 0.0;
  double woken_s_ = -1.0;  // when, negative = long ago
};

}  // namespace plants::sixth

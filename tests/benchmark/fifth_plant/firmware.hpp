#pragma once

#include "tests/benchmark/fifth_plant/delay_line.hpp"
#include "tests/benchmark/plants/random.hpp"

namespace plants::fifth {

// From the commands that were sent to the wheel speeds that the motor drivers are asked for.
class Firmware {
 public:
  Firmware(const FirmwareSpec& spec, double wheel_base_m, const Random& random);

  PerWheel<double> step(const PerWheel<double>& command_m_s);
  // A wheel is asked to turn.
  [[nodiscard]] bool driving() const { return driving_; }

 private:
  PerWheel<double> through_radio(const PerWheel<double>& command_m_s);
  [[nodiscard]] double understood_m_s(double command_m_s) const;
  [[nodiscard]] double steering_m_s() const;
  void approach(double& wanted_m_s, double target_m_s) const;

  FirmwareSpec spec_;
  double wheel_base_m_;
  Random random_;
  DelayLine<PerWheel<double>> link_;
  PerWheel<double> held_m_s_{};
  PerWheel<double> ramped_m_s_{};
  PerWheel<double> smooth_m_s_{};
  double time_s_ = 0.0;
  double stall_from_s_ = no_limit;
  bool driving_ = false;
};

}  // namespace plants::fifth

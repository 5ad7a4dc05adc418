#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// Battery and converter. Without what is hidden, motors notice nothing of the battery.
class Supply {
 public:
  Supply(const Robot& robot, const Hidden& hidden, double duration_s, Random& chance);

  // A voltage that a side asks for, as it comes out; in metres per second.
  [[nodiscard]] double weakened(double asked_m_s, std::size_t side) const;
  void step(double time_s, const PerWheel<double>& force_n, double left_m_s);
  [[nodiscard]] double battery_v(double time_s) const;

 private:
  const Robot& robot_;
  const Hidden& hidden_;
  double duration_s_;
  double charge_share_;
  double battery_share_;
  double drawn_share_ = 0.0;  // of the current at full force
  double droop_share_ = 0.0;
  double heat_ = 0.0;
  bool hot_ = false;
};

}  // namespace plants::sixth

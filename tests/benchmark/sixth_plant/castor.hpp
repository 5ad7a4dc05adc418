#pragma once

#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// The fork of the castor, which comes round after a reversal and pushes while it stands the wrong way.
class Castor {
 public:
  Castor(const Robot& robot, const Hidden& hidden) : robot_(robot), hidden_(hidden) {}

  // Yaw moment, up to the largest one.
  double step(double largest_n_m, double forward_m_s, double turn_rad_s);

 private:
  const Robot& robot_;
  const Hidden& hidden_;
  double fork_rad_ = 0.0;
};

}  // namespace plants::sixth

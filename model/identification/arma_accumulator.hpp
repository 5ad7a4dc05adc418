// Eq. (12) row by row, for both wheels: the paper's ARMA calibration as it can run beside the robot.
//
// Each row says that the speed of a wheel over one period is the weighted sum of both commands and of the
// wheel's own past speeds (ArmaLayout). Rows go into one small triangle per wheel, so memory does not grow
// with the log; adding a period costs O(order^2) operations and allocates nothing.
//
// Past speeds come from the encoders and carry their noise, which biases the weights of the past towards
// zero (errors in variables): with 0.44 mm ticks the free run of such a model is visibly too quick. fit_arma
// repairs that; this is its first step, and the reference.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/identification/arma_layout.hpp"
#include "model/identification/least_squares_accumulator.hpp"

namespace wheelwright {

class ArmaAccumulator {
 public:
  explicit ArmaAccumulator(const ArmaLayout& layout);

  // A run begins with a robot at rest: past commands and speeds are zero.
  void start_from_rest();

  // What happened before the next period is not known (a hole in the log). Rows that would need it are left
  // out until it has passed.
  void lose_past();

  // The next period: its command in m/s and the mean speed of each wheel over it, where it is known.
  void add(const WheelPair& command_m_s, const std::optional<WheelPair>& speed_m_s);

  Eigen::Index rows() const { return left_.equations.rows(); }

  // The equations so far as small triangles with the same solutions.
  LeastSquaresAccumulator::Factor left_factor() { return left_.equations.factor(); }
  LeastSquaresAccumulator::Factor right_factor() { return right_.equations.factor(); }

 private:
  struct Wheel {
    LeastSquaresAccumulator equations;
    Eigen::RowVectorXd row;  // commands and past speeds, as ArmaLayout orders them
  };

  void add_row(Wheel& wheel, double speed_m_s);
  void remember_speed(Wheel& wheel, double speed_m_s);
  void remember_command(const WheelPair& command_m_s);

  ArmaLayout layout_;
  Wheel left_;
  Wheel right_;
  Eigen::RowVectorXd commands_;  // newest first, left before right, from i=0
  std::size_t commands_known_ = 0;
  std::size_t speeds_known_ = 0;
};

}  // namespace wheelwright

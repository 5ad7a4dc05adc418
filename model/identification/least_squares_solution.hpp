// The solution of the small triangle that LeastSquaresAccumulator leaves, by singular values.
#pragma once

#include <Eigen/Core>

#include "model/identification/least_squares_accumulator.hpp"

namespace wheelwright {

struct SmallSolution {
  Eigen::VectorXd unknowns;        // of least norm (in units of the columns' size) where rank is short
  Eigen::VectorXd deviations;      // one standard error of each; of the part that the data determine
  Eigen::MatrixXd covariance;      // the same with its couplings
  double condition = 0.0;          // largest singular value over the smallest one, columns scaled alike
  Eigen::Index rank = 0;           // singular values above `rank_tolerance` of the largest
  double residual_variance = 0.0;  // square sum per degree of freedom left
};

// Below this share of the largest singular value a direction of the unknowns counts as not seen at all.
inline constexpr double rank_tolerance = 1e-11;

// Solves for one of the right-hand sides. Columns are scaled to equal size first, so that condition and rank
// do not depend on the units of the commands.
SmallSolution solve_small(const LeastSquaresAccumulator::Factor& factor, Eigen::Index output = 0);

// The same unknowns in a tenth of the time and nothing else, for a fit beside the robot: by pivoted QR in
// place of singular values. Directions below rank_tolerance get no part of the solution.
Eigen::VectorXd solve_quickly(const LeastSquaresAccumulator::Factor& factor, Eigen::Index output = 0);

// Levenberg-Marquardt steps of any damping from one factorisation.
class DampedSteps {
 public:
  explicit DampedSteps(const LeastSquaresAccumulator::Factor& factor);

  // The step for a damping relative to the squared largest singular value; 0 is the full step, in which
  // directions below rank_tolerance stay put.
  Eigen::VectorXd step(double damping) const;

 private:
  Eigen::VectorXd scale_;
  Eigen::VectorXd singular_;
  Eigen::MatrixXd v_;
  Eigen::VectorXd image_;
};

// Square sum of the residual of any other unknowns in the same equations.
double residual_square_sum(const LeastSquaresAccumulator::Factor& factor, const Eigen::VectorXd& unknowns,
                           Eigen::Index output = 0);

}  // namespace wheelwright

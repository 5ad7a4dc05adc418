// The least-squares problem of ModelAdaptation.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// What may change, as one vector: three weights for each wheel, left first, then the sizes of effects.
class AdaptedParameters {
 public:
  explicit AdaptedParameters(const RobotModel& model);

  Eigen::VectorXd present() const { return present_; }
  // Standard deviation of how far each changes while a robot is used.
  const Eigen::VectorXd& deviations() const { return deviations_; }
  // Within what is physically possible.
  Eigen::VectorXd bounded(const Eigen::VectorXd& parameters) const;
  // The model with these parameters; intervals of effects move along.
  RobotModel model_with(const Eigen::VectorXd& parameters) const;

 private:
  struct Size {
    std::size_t effect;
    std::size_t parameter;
    double lower;
    double upper;
  };

  RobotModel model_;
  std::vector<Size> sizes_;
  Eigen::VectorXd present_;
  Eigen::VectorXd deviations_;
};

// The residual, in standard deviations, of a parameter vector.
using ResidualOf = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

// Minimises |residual|^2 + |(parameters - present) / deviations|^2 by Levenberg and Marquardt's method,
// within the bounds.
Eigen::VectorXd most_likely(const AdaptedParameters& parameters, const ResidualOf& residual_of);

}  // namespace wheelwright

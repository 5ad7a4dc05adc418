// Two effects that are worth a fit together, by what each changes of the residuals.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "model/gap/candidates/screening.hpp"

namespace wheelwright::gap {

// What changes of the residuals have in common with each other and with what is left, after the model's own
// parameters have taken up what they can.
struct Common {
  Eigen::MatrixXd products;
  Eigen::VectorXd with_left;

  Common of(Eigen::Index first, Eigen::Index count) const {
    return {products.block(first, first, count, count), with_left.segment(first, count)};
  }
};

inline bool vanishes_at_zero(const ParameterInfo& parameter) {
  return parameter.lower <= 0.0 && parameter.upper >= 0.0;
}

// The pair that explains far more than any of `effects` does alone. `common` holds them in the same order.
std::optional<ScreenedPair> stronger_pair(std::span<const Screened> effects, const Common& common);

}  // namespace wheelwright::gap

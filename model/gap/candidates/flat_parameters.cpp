#include "model/gap/candidates/flat_parameters.hpp"

namespace wheelwright::gap {
namespace {

constexpr double worth_it = 2.0;  // of the sum of squares: a nat

bool is_flat(const FitProblem& train, const Fit& fit, std::size_t parameter) {
  if (fit.model.parameter_info(parameter)->sizes.empty()) return false;
  TrialModel moved = fit.model;
  moved.set_parameter(parameter, fit.model.parameter(parameter) + small_step(fit.model, parameter));
  return train.residuals(moved) == train.residuals(fit.model);
}

}  // namespace

Fit away_from_flat_parameters(const FitProblem& train, const Fit& fit, int steps) {
  Fit best = fit;
  for (std::size_t i = fit.model.linear_part.size(); i < fit.model.parameter_count(); ++i) {
    if (!is_flat(train, best, i)) continue;
    for (const double size : fit.model.parameter_info(i)->sizes) {
      if (size == fit.model.parameter(i)) continue;
      TrialModel start = best.model;
      start.set_parameter(i, size);
      Fit other = train.fit(start, steps);
      if (other.sum_squares < best.sum_squares - worth_it) best = std::move(other);
    }
  }
  return best;
}

}  // namespace wheelwright::gap

#include "model/gap/selection/default_linear_part.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {

TrialModel with_default_linear_part(TrialModel model, double lag_s) {
  const double delay_s = 2.0 * model.period_s;
  model.linear_part =
      first_guess(model.shape, model.period_s, model.wheel_base_m, lag_s, delay_s).linear_part;
  return model;
}

bool reaches_far(const TrialModel& model) {
  constexpr double longest_lag_s = 0.5;
  const LinearModel linear_part = model.linear();
  return std::max(largest_pole(linear_part.left), largest_pole(linear_part.right)) >
         std::exp(-model.period_s / longest_lag_s);
}

const TrialModel& closest_to_runs(const FitProblem& train, const std::vector<TrialModel>& models,
                                  const ParallelFor& parallel_for) {
  std::vector<double> sum_squares(models.size());
  parallel_for(models.size(),
               [&](std::size_t i) { sum_squares[i] = sum_squares_of(train.residuals(models[i])); });
  return models[static_cast<std::size_t>(std::ranges::min_element(sum_squares) - sum_squares.begin())];
}

}  // namespace wheelwright::gap

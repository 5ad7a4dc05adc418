#include "model/gap/selection/search_start.hpp"

#include <algorithm>
#include <cmath>

#include "model/effects/library/effect_library.hpp"

namespace wheelwright::gap {
namespace {

LinearPartShape shape_for(const FitProblem& train) {
  LinearPartShape shape;
  shape.shared = !train.has_counts();
  // First and last references alone, at rest, tell of any moment.
  constexpr std::size_t while_it_drives = 10;
  shape.reference_lag = std::ranges::all_of(train.runs(), [](const GapRun& run) {
    return run.has_counts && (run.by_gyro || run.references.size() > while_it_drives);
  });
  shape.gyro_scaled = std::ranges::any_of(train.runs(), &GapRun::by_gyro);
  // A linear part that reaches back 90 ms holds what delay is usual of a serial line and a motor; more of it
  // is an effect.
  const double period_s = train.runs().front().period_s;
  shape.weights = static_cast<std::size_t>(std::clamp(std::lround(0.09 / period_s) + 1, 3L, 10L));
  return shape;
}

}  // namespace

std::vector<TrialEffect> trial_effects_of(const RobotModel& model) {
  std::vector<TrialEffect> effects;
  for (const auto& effect : model.effects) {
    const EffectInfo* info = find_effect(effect.setting.name);
    effects.push_back({info, variant_index(*info, effect.setting.variant), effect.setting.parameters});
  }
  return effects;
}

TrialModel search_start(FitProblem& train, const RobotModel* given) {
  const GapRun& run = train.runs().front();
  TrialModel best;
  double least = 0.0;
  for (const double lag_s : {0.06, 0.15}) {
    TrialModel guess = first_guess(shape_for(train), run.period_s, run.wheel_base_m, lag_s, 0.036);
    if (given != nullptr) guess.effects = trial_effects_of(*given);
    train.set_noise({});
    const Fit fit = train.fit(guess, 8);
    if (best.linear_part.empty() || fit.sum_squares < least) {
      best = fit.model;
      least = fit.sum_squares;
    }
  }
  return best;
}

}  // namespace wheelwright::gap

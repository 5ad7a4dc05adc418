#include "model/gap/conclusion/confirmation.hpp"

#include <algorithm>
#include <iterator>

#include "model/gap/adequacy/variance_ratio.hpp"
#include "model/gap/candidates/eccentricity_phase.hpp"

namespace wheelwright::gap {
namespace {

constexpr int refit_steps = 6;

TrialModel without(const TrialModel& model, std::size_t effect) {
  TrialModel rest = model;
  rest.effects.erase(std::next(rest.effects.begin(), static_cast<std::ptrdiff_t>(effect)));
  return rest;
}

void find_initial_travel(const GapProblem& train, const TrialModel& model, GapProblem& problem, RunSet& runs,
                         const ForEach& for_each) {
  for (std::size_t i = 0; i < model.effects.size(); ++i) {
    const EffectInfo& info = *model.effects[i].info;
    if (!info.by_wheel_angle) continue;
    const GapFit fit = train.fit(without(model, i), refit_steps);
    const auto angles = find_wheel_angles(train, problem, fit, info, for_each);
    if (!angles || !angles->differ) return;
    problem.set_rolled_before(angles->heldout_rolled_m);
    for (std::size_t r = 0; r < runs.runs.size(); ++r) {
      runs.runs[r].rolled_before_m = runs.logs[r].rolled_before_m = angles->heldout_rolled_m[r];
    }
    return;
  }
}

}  // namespace

Confirmation confirm(const GapProblem& train, const GapSearch& search, RunSet& runs, bool untouched,
                     const ForEach& for_each) {
  const TrialModel& accepted = search.final.model;
  const NoiseModel noise = train.noise_left_by(accepted);
  GapProblem known = train;
  known.set_noise(noise);
  GapProblem problem(runs.runs, runs.metres_per_tick, for_each);
  problem.set_noise(noise);
  find_initial_travel(known, accepted, problem, runs, for_each);

  Confirmation result;
  result.check = predictive_check(problem, accepted);
  if (!untouched) return result;
  const auto residuals = problem.residuals(accepted);
  const double ratio = variance_ratio(problem, residuals);
  for (std::size_t i = 0; i < accepted.effects.size(); ++i) {
    const GapFit rest = known.fit(without(accepted, i), refit_steps);
    const double gain = 0.5 * (squares_of(problem.residuals(rest.model)) - squares_of(residuals));
    result.effect_nats.push_back(gain / ratio);
    result.acts.push_back(problem.residuals(without(accepted, i)) != residuals);
  }
  return result;
}

}  // namespace wheelwright::gap

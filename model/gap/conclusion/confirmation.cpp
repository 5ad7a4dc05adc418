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

void find_initial_travel(const FitProblem& train, const TrialModel& model, FitProblem& problem, RunSet& runs,
                         const ParallelFor& parallel_for) {
  for (std::size_t i = 0; i < model.effects.size(); ++i) {
    const EffectInfo& info = *model.effects[i].info;
    if (!info.by_wheel_angle) continue;
    const Fit fit = train.fit(without(model, i), refit_steps);
    const auto angles = find_eccentricity_phases(train, problem, fit, info, parallel_for);
    if (!angles || !angles->differ) return;
    problem.set_initial_travel(angles->heldout_rolled_m);
    for (std::size_t r = 0; r < runs.runs.size(); ++r) {
      runs.runs[r].initial_travel_m = runs.logs[r].initial_travel_m = angles->heldout_rolled_m[r];
    }
    return;
  }
}

}  // namespace

Confirmation confirm(const FitProblem& train, const GapSearch& search, RunSet& runs, bool untouched,
                     const ParallelFor& parallel_for) {
  const TrialModel& accepted = search.final.model;
  const NoiseModel noise = train.noise_left_by(accepted);
  FitProblem known = train;
  known.set_noise(noise);
  FitProblem problem(runs.runs, runs.metres_per_tick, parallel_for);
  problem.set_noise(noise);
  find_initial_travel(known, accepted, problem, runs, parallel_for);

  Confirmation result;
  result.check = predictive_check(problem, accepted);
  if (accepted.effects.empty()) return result;
  const auto residuals = problem.residuals(accepted);
  const double ratio = variance_ratio(problem, residuals);
  const auto gain_over = [&](const TrialModel& rest) {
    const Fit fit = known.fit(rest, refit_steps);
    return 0.5 * (sum_squares_of(problem.residuals(fit.model)) - sum_squares_of(residuals)) / ratio;
  };
  result.gain_nats = gain_over(search.baseline.model);
  if (!untouched) return result;
  for (std::size_t i = 0; i < accepted.effects.size(); ++i) {
    result.effect_nats.push_back(gain_over(without(accepted, i)));
    result.acts.push_back(problem.residuals(without(accepted, i)) != residuals);
  }
  return result;
}

TrialModel likeliest_within_intervals(const FitProblem& train, const GapSearch& search, const RunSet& runs,
                                      const ParallelFor& parallel_for) {
  constexpr int places = 8;
  TrialModel best = search.final.model;
  FitProblem problem(runs.runs, runs.metres_per_tick, parallel_for);
  problem.set_noise(train.noise_left_by(best));
  double least = sum_squares_of(problem.residuals(best));
  const std::size_t first = best.linear_part.size();
  for (std::size_t i = 0; i < search.intervals.size(); ++i) {
    const auto& [lower, upper] = search.intervals[i];
    for (int place = 0; place <= places; ++place) {
      TrialModel tried = best;
      tried.set_parameter(first + i, lower + (upper - lower) * place / places);
      const double sum_squares = sum_squares_of(problem.residuals(tried));
      if (sum_squares >= least) continue;
      least = sum_squares;
      best = std::move(tried);
    }
  }
  return best;
}

}  // namespace wheelwright::gap

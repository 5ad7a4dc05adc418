#include "model/gap/candidates/quantization_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "model/gap/candidates/command_spectrum.hpp"
#include "model/gap/candidates/steady_response.hpp"
#include "model/gap/runs/fastest_command.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::gap {
namespace {

constexpr double smallest_level_step_m_s = 0.0025;
constexpr double largest_shift_of_levels =
    0.1;                                      // of a step, at the fastest command, between two that are tried
constexpr double stands_out = 6.0;            // standard deviations of what wrong steps show
constexpr std::size_t response_periods = 80;  // beyond the weights
constexpr std::size_t farthest_readings_periods = 3;

// All periods of a wheel in which it was told the same.
struct Commanded {
  double command_m_s = 0.0;
  double periods = 0.0;
  double evidence = 0.0;  // residual speed, turned round: what a change of this command would explain
};

// What the model leaves of a wheel's travel, per period. Empty where it is not known closely enough.
std::vector<double> residual_increments(const Series& measured, const std::vector<double>& model_m) {
  std::vector<double> increments(model_m.size(), 0.0);
  for (std::size_t i = 1; i < measured.at.size(); ++i) {
    const std::size_t from = measured.at[i - 1].period;
    const std::size_t to = measured.at[i].period;
    if (to <= from || to >= model_m.size() || measured.restarts[i] != 0) continue;
    if (to - from > farthest_readings_periods) return {};
    const double left = measured.value[i] - measured.value[i - 1] - (model_m[to] - model_m[from]);
    for (std::size_t k = from; k < to; ++k) increments[k] = left / static_cast<double>(to - from);
  }
  return increments;
}

// Of both wheels, from counts or from what the body does.
std::array<std::vector<double>, 2> residual_speeds(const GapRun& run, const TrialModel& model) {
  const auto states = model_states(model, run);
  std::vector<double> left;
  std::vector<double> right;
  for (const auto& state : states) {
    left.push_back(state.distance_m.left);
    right.push_back(state.distance_m.right);
  }
  if (run.has_counts) {
    return {residual_increments(run[Channel::left], left), residual_increments(run[Channel::right], right)};
  }
  std::vector<double> forward(left.size());
  std::vector<double> turn(left.size());
  for (std::size_t k = 0; k < left.size(); ++k) {
    forward[k] = 0.5 * (left[k] + right[k]);
    turn[k] = (right[k] - left[k]) / run.wheel_base_m;
  }
  const auto ahead = residual_increments(run[Channel::forward], forward);
  const auto round = residual_increments(run[Channel::turn], turn);
  if (ahead.empty() || round.empty()) return {};
  std::array<std::vector<double>, 2> wheels;
  for (std::size_t k = 0; k < ahead.size(); ++k) {
    const double half = 0.5 * round[k] * run.wheel_base_m;
    wheels[0].push_back(ahead[k] - half);
    wheels[1].push_back(ahead[k] + half);
  }
  return wheels;
}

std::vector<double> impulse_response(const WheelResponse& wheel, const std::vector<double>& own) {
  std::vector<double> response(own.size() + response_periods, 0.0);
  for (std::size_t k = 0; k < response.size(); ++k) {
    if (k < own.size()) response[k] = own[k];
    for (std::size_t i = 1; i <= std::min(k, wheel.from_own_past.size()); ++i)
      response[k] += wheel.from_own_past[i - 1] * response[k - i];
  }
  return response;
}

std::vector<double> turned_round(const std::vector<double>& residuals, const std::vector<double>& response) {
  std::vector<double> evidence(residuals.size(), 0.0);
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    const std::size_t last = std::min(response.size(), residuals.size() - k);
    for (std::size_t j = 0; j < last; ++j) evidence[k] += response[j] * residuals[k + j];
  }
  return evidence;
}

std::vector<Commanded> by_command(const GapRun& run, bool right, const std::vector<double>& evidence) {
  std::map<double, Commanded> all;
  for (std::size_t k = 0; k < std::min(run.commands_m_s.size(), evidence.size()); ++k) {
    const double u = right ? run.commands_m_s[k].right : run.commands_m_s[k].left;
    if (u == 0.0) continue;
    Commanded& same = all[u];
    same.command_m_s = u;
    same.periods += 1.0;
    same.evidence += evidence[k];
  }
  std::vector<Commanded> commands;
  commands.reserve(all.size());
  for (const auto& [u, same] : all) commands.push_back(same);
  return commands;
}

using WheelCommands = std::vector<std::vector<Commanded>>;  // of each wheel in each run

WheelCommands gathered(const FitProblem& problem, const TrialModel& model) {
  WheelCommands all;
  const LinearModel linear_part = model.with_delay_in_linear_part().linear();
  const auto of_left = impulse_response(linear_part.left, linear_part.left.from_left);
  const auto of_right = impulse_response(linear_part.right, linear_part.right.from_right);
  for (const auto& run : problem.runs()) {
    if (!run.has_counts && run.sparse) continue;
    const auto residuals = residual_speeds(run, model);
    for (const bool right : {false, true}) {
      const auto& of_wheel = residuals[right ? 1 : 0];
      if (of_wheel.empty()) continue;
      all.push_back(by_command(run, right, turned_round(of_wheel, right ? of_right : of_left)));
    }
  }
  return all;
}

std::vector<CommandSteps> steps_and_edges_to_try(double fastest) {
  std::vector<CommandSteps> steps;
  if (fastest <= 0.0) return steps;
  const double apart = largest_shift_of_levels / fastest;
  for (const double level_edges : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    for (double per_m_s = 1.0 / smallest_level_step_m_s; per_m_s > 1.0 / largest_command_step_m_s(fastest);
         per_m_s -= apart) {
      steps.push_back({1.0 / per_m_s, level_edges});
    }
  }
  return steps;
}

// Between those that were tried.
std::vector<CommandSteps> steps_around(const CommandSteps& middle) {
  std::vector<CommandSteps> steps;
  for (int i = -8; i <= 8; ++i) {
    for (int j = -10; j <= 10; ++j) {
      const double level_edges = middle.level_edges + 0.025 * i;
      if (level_edges < 0.0 || level_edges > 1.0) continue;
      steps.push_back({middle.step_m_s * (1.0 + 0.001 * j), level_edges});
    }
  }
  return steps;
}

double side_of(double value) {
  return value > 0.0 ? 1.0 : -1.0;
}

// Correlation of the evidence with what the effect does to the commands, as far as the model's other effects
// pass that on, over the size of that. What a gain or a loss by sign explains is no sign of steps.
double likeness(const WheelCommands& wheels, const SteadyResponse& passed_on, const EffectInfo& info,
                const CommandSteps& steps) {
  const std::array parameters{steps.step_m_s, steps.level_edges};
  const auto effect = info.make({parameters, 0});
  double agreement = 0.0;
  double power = 0.0;
  for (const auto& wheel : wheels) {
    std::vector<double> change(wheel.size());
    double by_command = 0.0;
    double by_sign = 0.0;
    double commands = 0.0;
    double signs = 0.0;
    double both = 0.0;
    for (std::size_t i = 0; i < wheel.size(); ++i) {
      const auto& [u, periods, evidence] = wheel[i];
      WheelPair acted{u, u};
      effect->command(acted, {});
      const double seen = passed_on.slope(u);
      change[i] = passed_on.at(acted.left) - passed_on.at(u);
      by_command += periods * change[i] * seen * u;
      by_sign += periods * change[i] * seen * side_of(u);
      commands += periods * seen * seen * u * u;
      signs += periods * seen * seen;
      both += periods * seen * seen * std::abs(u);
    }
    const double determinant = commands * signs - both * both;
    if (!(determinant > 1e-9 * commands * signs)) continue;
    const double gain = (by_command * signs - by_sign * both) / determinant;
    const double loss = (by_sign * commands - by_command * both) / determinant;
    for (std::size_t i = 0; i < wheel.size(); ++i) {
      const auto& [u, periods, evidence] = wheel[i];
      const double left = change[i] - passed_on.slope(u) * (gain * u + loss * side_of(u));
      agreement += left * evidence;
      power += periods * left * left;
    }
  }
  return power > 0.0 ? agreement / std::sqrt(power) : 0.0;
}

double median_size(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return median(std::move(values));
}

struct BestSteps {
  CommandSteps steps;
  bool stands_out = false;
};

BestSteps best_of(const std::vector<CommandSteps>& steps, const WheelCommands& wheels,
                  const SteadyResponse& passed_on, const EffectInfo& info, const ParallelFor& parallel_for) {
  std::vector<double> likenesses(steps.size());
  parallel_for(steps.size(),
               [&](std::size_t i) { likenesses[i] = likeness(wheels, passed_on, info, steps[i]); });
  const auto best = std::ranges::max_element(likenesses);
  return {steps[static_cast<std::size_t>(best - likenesses.begin())],
          *best >= stands_out * deviations_of_median_size * median_size(likenesses)};
}

// Commands that change all the time, so that there is little to learn of any one of them.
bool hardly_repeat(const WheelCommands& wheels) {
  constexpr double min_share = 0.05;
  double commands = 0.0;
  double periods = 0.0;
  for (const auto& wheel : wheels) {
    commands += static_cast<double>(wheel.size());
    for (const auto& told : wheel) periods += told.periods;
  }
  return commands > min_share * periods;
}

}  // namespace

std::optional<TrialEffect> find_command_steps(const FitProblem& train, const Fit& fit, const EffectInfo& info,
                                              const ParallelFor& parallel_for) {
  const WheelCommands wheels = gathered(train, fit.model);
  if (hardly_repeat(wheels)) {
    const auto steps = find_steps_by_spectrum(train, fit, info, parallel_for);
    if (!steps) return std::nullopt;
    return TrialEffect{&info, 0, {steps->step_m_s, steps->level_edges}};
  }
  const double fastest_m_s = fastest_command_m_s(train.runs());
  const std::vector<CommandSteps> steps = steps_and_edges_to_try(fastest_m_s);
  if (steps.empty()) return std::nullopt;
  const SteadyResponse passed_on(fit.model, fastest_m_s);
  const BestSteps near = best_of(steps, wheels, passed_on, info, parallel_for);
  if (!near.stands_out) return std::nullopt;
  const BestSteps best = best_of(steps_around(near.steps), wheels, passed_on, info, parallel_for);
  return TrialEffect{&info, 0, {best.steps.step_m_s, best.steps.level_edges}};
}

}  // namespace wheelwright::gap

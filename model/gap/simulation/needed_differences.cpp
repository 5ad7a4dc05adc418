#include "model/gap/simulation/needed_differences.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/gap/adequacy/variance_ratio.hpp"
#include "model/gap/linear_changes/linear_changes.hpp"

namespace wheelwright::gap {
namespace {

constexpr int max_steps = 10;

// An effect of either; it is the simulation's until it has to differ.
struct Alternative {
  std::string name;
  std::optional<TrialEffect> of_simulation;
  std::optional<TrialEffect> of_robot;
  bool differs = false;

  const std::optional<TrialEffect>& taken() const { return differs ? of_robot : of_simulation; }
};

bool is_of_robot_alone(const EffectInfo& info) {
  return info.linear || info.variants.front().stage == EffectStage::counts;
}

std::vector<Alternative> alternatives(std::span<const TrialEffect> of_simulation,
                                      std::span<const TrialEffect> of_robot) {
  std::vector<Alternative> all;
  for (const TrialEffect& effect : of_robot)
    all.push_back({effect.info->name, std::nullopt, effect, is_of_robot_alone(*effect.info)});
  for (const TrialEffect& effect : of_simulation) {
    if (is_of_robot_alone(*effect.info)) continue;
    const auto same = std::ranges::find(all, effect.info->name, &Alternative::name);
    if (same != all.end()) {
      same->of_simulation = effect;
    } else {
      all.push_back({effect.info->name, effect, std::nullopt, false});
    }
  }
  return all;
}

// Effects that stay as the simulation has them are held.
Fit fitted(const FitProblem& train, TrialModel start, const std::vector<Alternative>& all) {
  start.effects.clear();
  std::vector<char> is_held(start.linear_part.size(), 0);
  for (const Alternative& one : all) {
    if (!one.taken()) continue;
    start.effects.push_back(*one.taken());
    is_held.insert(is_held.end(), one.taken()->parameters.size(), one.differs ? 0 : 1);
  }
  return train.fit_with_held(start, max_steps, is_held);
}

// The difference that gains the most on the training runs; none is left where all were made.
std::optional<std::pair<std::size_t, Fit>> best_difference(const FitProblem& train, const TrialModel& start,
                                                           const std::vector<Alternative>& all) {
  std::optional<std::pair<std::size_t, Fit>> best;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].differs) continue;
    std::vector<Alternative> other = all;
    other[i].differs = true;
    Fit fit = fitted(train, start, other);
    if (!best || fit.sum_squares < best->second.sum_squares) best = {i, std::move(fit)};
  }
  return best;
}

}  // namespace

NeededDifferences needed_differences(std::span<const TrialEffect> of_simulation, const TrialModel& of_robot,
                                     const FitProblem& train, const FitProblem& heldout) {
  const std::vector<double> found = heldout.residuals(of_robot);
  const double deflation = variance_ratio(heldout, found);
  const auto nats_short = [&](const TrialModel& model) {
    return 0.5 * (sum_squares_of(heldout.residuals(model)) - sum_squares_of(found)) / deflation;
  };
  std::vector<Alternative> all = alternatives(of_simulation, of_robot.effects);
  Fit fit = fitted(train, of_robot, all);
  NeededDifferences needed;
  for (const Alternative& one : all) {
    if (one.differs) needed.effects.push_back(one.name);
  }
  while (nats_short(fit.model) >= confirming_nats) {
    auto next = best_difference(train, of_robot, all);
    if (!next) break;
    all[next->first].differs = true;
    needed.effects.push_back(all[next->first].name);
    fit = std::move(next->second);
  }
  needed.model = std::move(fit.model);
  return needed;
}

}  // namespace wheelwright::gap

#include "model/gap/candidates/fork_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace wheelwright::gap {
namespace {

constexpr std::size_t forks = 160;
constexpr std::size_t fitted = 4;  // the best of them
constexpr int steps = 5;

// In wheel bases: the fork's own length, and from the axle to its pivot.
constexpr double shortest_trail = 0.025;
constexpr double longest_trail = 0.2;
constexpr double shortest_arm = 0.1;
constexpr double longest_arm = 0.8;
constexpr double largest_lean_rad = 0.15;

std::optional<std::size_t> index_of(const TrialEffect& effect, std::string_view name) {
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    if (effect.parameter_info(i).name == name) return i;
  }
  return std::nullopt;
}

// The i-th point of a sequence that fills a cube evenly: multiples of the powers of 1/g, g^4 = g + 1, modulo
// 1 (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
struct Shares {
  double trail;
  double arm;
  double lean;
};
Shares shares(std::size_t i) {
  constexpr double g = 1.22074408460575947536;
  const auto share = [i](double step) { return std::fmod(0.5 + static_cast<double>(i + 1) * step, 1.0); };
  return {share(1.0 / g), share(1.0 / (g * g)), share(1.0 / (g * g * g))};
}

TrialEffect fork(TrialEffect effect, std::size_t i, double wheel_base_m) {
  const Shares share = shares(i);
  const auto set = [&](std::string_view name, double value) {
    if (const auto index = index_of(effect, name)) effect.parameters[*index] = value;
  };
  set("trail", wheel_base_m * shortest_trail * std::pow(longest_trail / shortest_trail, share.trail));
  const double aside = 2.0 * share.arm - 1.0;
  const double arm = std::copysign(shortest_arm + (longest_arm - shortest_arm) * std::abs(aside), aside);
  set("arm", arm * wheel_base_m);
  set("lean", largest_lean_rad * (2.0 * share.lean - 1.0));
  for (std::size_t k = 0; k < effect.parameters.size(); ++k) {
    const ParameterInfo& info = effect.parameter_info(k);
    if (info.scales_effect && effect.parameters[k] == 0.0) effect.parameters[k] = smallest_size(info);
  }
  return effect.within_bounds();
}

struct Drawn {
  TrialModel model;
  double sum_squares = 0.0;
};

class ForkSearch {
 public:
  ForkSearch(const FitProblem& train, const TrialModel& model)
      : train_(train), model_(model), outputs_(train.outputs_of(model.effects.back())) {
    TrialModel without = model;
    without.effects.pop_back();
    without_ = train.residuals(without, outputs_);
  }

  Drawn with(std::size_t i) const {
    Drawn drawn{model_, 0.0};
    TrialEffect& effect = drawn.model.effects.back();
    effect = fork(effect, i, model_.wheel_base_m);
    const double amount = amount_of(train_.residuals(drawn.model, outputs_));
    for (std::size_t k = 0; k < effect.parameters.size(); ++k) {
      if (effect.parameter_info(k).scales_effect) effect.parameters[k] *= amount;
    }
    effect = effect.within_bounds();
    drawn.sum_squares = sum_squares_of(train_.residuals(drawn.model, outputs_));
    return drawn;
  }

  Drawn fitted_from(const TrialModel& start) const {
    Fit fit = train_.fit(start, steps, outputs_);
    return {std::move(fit.model), fit.sum_squares};
  }

 private:
  // By how much the change would have to be larger to explain the most.
  double amount_of(const std::vector<double>& residuals) const {
    double power = 0.0;
    double with_left = 0.0;
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      const double change = residuals[k] - without_[k];
      power += change * change;
      with_left += change * without_[k];
    }
    return power > 0.0 ? -with_left / power : 1.0;
  }

  const FitProblem& train_;
  const TrialModel& model_;
  Outputs outputs_;
  std::vector<double> without_;
};

}  // namespace

bool has_fork(const TrialEffect& effect) {
  return index_of(effect, "trail").has_value();
}

TrialModel with_fork_found(const FitProblem& train, const TrialModel& model,
                           const ParallelFor& parallel_for) {
  const ForkSearch search(train, model);
  std::vector<Drawn> drawn(forks);
  parallel_for(forks, [&](std::size_t i) { drawn[i] = search.with(i); });
  std::ranges::partial_sort(drawn, drawn.begin() + fitted, {}, &Drawn::sum_squares);
  drawn.resize(fitted);
  drawn.push_back({model, 0.0});
  parallel_for(drawn.size(), [&](std::size_t i) { drawn[i] = search.fitted_from(drawn[i].model); });
  return std::ranges::min_element(drawn, {}, &Drawn::sum_squares)->model;
}

}  // namespace wheelwright::gap

#include "model/gap/simulation/needed_differences.hpp"

#include <algorithm>
#include <optional>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/adequacy/variance_ratio.hpp"
#include "model/statistics/levenberg_marquardt.hpp"

namespace wheelwright::gap {
namespace {

constexpr double confirming_nats = 5.99;  // ln(4 / 0.01), as of changes of the linear part
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
  return info.name == "transport_delay" || info.name == "encoder_dropout";
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

// The fit of all parameters but those of effects that stay as the simulation has them.
class FitBeside {
 public:
  using Point = Fit;

  FitBeside(const FitProblem& problem, std::vector<bool> is_kept)
      : problem_(problem), is_kept_(std::move(is_kept)) {}

  Fit at(const TrialModel& model) const {
    Fit fit{model, 0.0, problem_.residuals(model)};
    fit.sum_squares = sum_squares_of(fit.residuals);
    return fit;
  }
  static double objective(const Fit& fit) { return fit.sum_squares; }
  NormalEquations linearise(const Fit& fit) const {
    Eigen::MatrixXd columns = problem_.jacobian(fit.model, fit.residuals);
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
      if (is_kept_[static_cast<std::size_t>(i)]) columns.col(i).setZero();
    }
    const Eigen::Map<const Eigen::VectorXd> residual(fit.residuals.data(), columns.rows());
    return {columns.transpose() * columns, columns.transpose() * residual};
  }
  std::optional<Fit> moved(const Fit& fit, const Eigen::VectorXd& step) const {
    const TrialModel model = fit.model.moved(step);
    if (!model.stable()) return std::nullopt;
    return at(model);
  }

 private:
  const FitProblem& problem_;
  std::vector<bool> is_kept_;
};

Fit fitted(const FitProblem& train, TrialModel start, const std::vector<Alternative>& all) {
  start.effects.clear();
  std::vector<bool> is_kept(start.linear_part.size(), false);
  for (const Alternative& one : all) {
    if (!one.taken()) continue;
    start.effects.push_back(*one.taken());
    is_kept.insert(is_kept.end(), one.taken()->parameters.size(), !one.differs);
  }
  const FitBeside problem(train, std::move(is_kept));
  return levenberg_marquardt(problem, problem.at(start), {.max_steps = max_steps, .min_fall = 0.2});
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

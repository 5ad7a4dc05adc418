#include "model/adaptation/adaptation_fit.hpp"

#include <algorithm>
#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "model/statistics/levenberg_marquardt.hpp"

namespace wheelwright {
namespace {

constexpr std::size_t lag_periods = 2;
constexpr Eigen::Index weights_of_wheel = 3;
constexpr double weight_deviation = 0.1;
// A correction makes a response longer; one that follows on many others may not do so for ever.
constexpr std::size_t longest_response = 100;

std::vector<double> filtered(const std::vector<double>& given, const Eigen::VectorXd& weights) {
  std::vector<double> result(given.size() + lag_periods * (weights_of_wheel - 1), 0.0);
  for (std::size_t i = 0; i < given.size(); ++i) {
    for (Eigen::Index j = 0; j < weights_of_wheel; ++j) {
      result[i + lag_periods * static_cast<std::size_t>(j)] += weights[j] * given[i];
    }
  }
  // What is left out this far back is next to nothing; the gain has to stay.
  while (result.size() > std::max(longest_response, given.size())) {
    const double last = result.back();
    result.pop_back();
    result.back() += last;
  }
  return result;
}

WheelResponse corrected(const WheelResponse& response, const Eigen::VectorXd& weights) {
  return {filtered(response.from_left, weights), filtered(response.from_right, weights),
          response.from_own_past};
}

class AdaptationFit {
 public:
  struct Point {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residual;
    double objective = 0.0;
  };

  AdaptationFit(const AdaptedParameters& parameters, const ResidualOf& residual_of)
      : parameters_(parameters), residual_of_(residual_of) {}

  Point at(const Eigen::VectorXd& parameters) const {
    Point point{parameters, residual_of_(parameters)};
    point.objective =
        point.residual.squaredNorm() +
        (parameters - parameters_.present()).cwiseQuotient(parameters_.deviations()).squaredNorm();
    return point;
  }
  static double objective(const Point& point) { return point.objective; }
  NormalEquations linearise(const Point& point) const {
    const Eigen::VectorXd prior = parameters_.deviations().cwiseAbs2().cwiseInverse();
    const Eigen::MatrixXd slopes = derivatives(point);
    Eigen::MatrixXd information = slopes.transpose() * slopes;
    information.diagonal() += prior;
    return {std::move(information), slopes.transpose() * point.residual +
                                        prior.cwiseProduct(point.parameters - parameters_.present())};
  }
  std::optional<Point> moved(const Point& point, const Eigen::VectorXd& step) const {
    return at(parameters_.bounded(point.parameters + step));
  }

 private:
  Eigen::MatrixXd derivatives(const Point& point) const {
    constexpr double step_in_deviations = 0.02;
    const Eigen::VectorXd& at = point.parameters;
    Eigen::MatrixXd slopes(point.residual.size(), at.size());
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      Eigen::VectorXd moved = at;
      moved[i] += step_in_deviations * parameters_.deviations()[i];
      moved = parameters_.bounded(moved);
      if (moved[i] == at[i]) moved[i] -= step_in_deviations * parameters_.deviations()[i];
      slopes.col(i) = (residual_of_(moved) - point.residual) / (moved[i] - at[i]);
    }
    return slopes;
  }

  const AdaptedParameters& parameters_;
  const ResidualOf& residual_of_;
};

}  // namespace

AdaptedParameters::AdaptedParameters(const RobotModel& model) : model_(model) {
  std::vector<double> present{1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  std::vector<double> deviations(present.size(), weight_deviation);
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const EffectSetting& setting = model.effects[e].setting;
    const EffectInfo* info = find_effect(setting.name);
    if (info == nullptr) continue;
    const std::size_t variant = variant_index(*info, setting.variant);
    if (info->variants[variant].stage != EffectStage::wheel || info->by_pose || info->by_wheel_angle)
      continue;
    const auto& infos = info->parameters_of(variant);
    for (std::size_t p = 0; p < infos.size(); ++p) {
      if (!infos[p].scales_effect || infos[p].sizes.empty()) continue;
      sizes_.push_back({e, p, infos[p].lower, infos[p].upper});
      present.push_back(setting.parameters[p]);
      deviations.push_back(std::max(std::abs(setting.parameters[p]), infos[p].sizes.front()));
    }
  }
  const auto count = static_cast<Eigen::Index>(present.size());
  present_ = Eigen::Map<Eigen::VectorXd>(present.data(), count);
  deviations_ = Eigen::Map<Eigen::VectorXd>(deviations.data(), count);
}

Eigen::VectorXd AdaptedParameters::bounded(const Eigen::VectorXd& parameters) const {
  Eigen::VectorXd result = parameters;
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    double& value = result[2 * weights_of_wheel + static_cast<Eigen::Index>(i)];
    value = std::clamp(value, sizes_[i].lower, sizes_[i].upper);
  }
  return result;
}

RobotModel AdaptedParameters::model_with(const Eigen::VectorXd& parameters) const {
  RobotModel model = model_;
  model.linear_part.left = corrected(model_.linear_part.left, parameters.head(weights_of_wheel));
  model.linear_part.right =
      corrected(model_.linear_part.right, parameters.segment(weights_of_wheel, weights_of_wheel));
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    AddedEffect& effect = model.effects[sizes_[i].effect];
    const std::size_t p = sizes_[i].parameter;
    const double value = parameters[2 * weights_of_wheel + static_cast<Eigen::Index>(i)];
    const double moved_by = value - effect.setting.parameters[p];
    effect.setting.parameters[p] = value;
    if (p >= effect.intervals.size()) continue;
    effect.intervals[p].lower = std::max(effect.intervals[p].lower + moved_by, sizes_[i].lower);
    effect.intervals[p].upper = std::min(effect.intervals[p].upper + moved_by, sizes_[i].upper);
  }
  return model;
}

Eigen::VectorXd most_likely(const AdaptedParameters& parameters, const ResidualOf& residual_of) {
  const AdaptationFit fit(parameters, residual_of);
  return levenberg_marquardt(fit, fit.at(parameters.present()), {.min_relative_fall = 1e-4}).parameters;
}

}  // namespace wheelwright

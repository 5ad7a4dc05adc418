#include "model/gap/fit/trial_model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "model/gap/fit/linear_part_weights.hpp"

namespace wheelwright::gap {
namespace {

constexpr double largest_pole_allowed = 0.995;

// Of a motor that creeps up to its speed.
double slow_pole(double period_s) {
  constexpr double creeping_s = 1.0;
  return std::exp(-period_s / creeping_s);
}

// How one wheel departs from a response that both share.
struct OfOneWheel {
  double gain = 1.0;
  double lag_periods = 0.0;
};

std::vector<double> scaled(const std::vector<double>& weights, double factor) {
  std::vector<double> result = weights;
  for (double& weight : result) weight *= factor;
  return result;
}

// y = 1/2 B/A (own + other) + 1/2 B'/A' (own - other), over the common denominator A A'.
WheelResponse response_of_modes(const LinearPartShape& shape, const double* values, bool left,
                                const OfOneWheel& of) {
  const auto [travel, turn] = modes_of(shape, values);
  const auto weights_of = [&](const Mode& mode, const Mode& other_mode) {
    const auto weights = shape.unequal_lags ? delayed(mode.weights, of.lag_periods) : mode.weights;
    return scaled(product(weights, other_mode.past), 0.5 * of.gain);
  };
  const std::vector<double> by_travel = weights_of(travel, turn);
  const std::vector<double> by_turn = weights_of(turn, travel);
  WheelResponse wheel;
  const std::vector<double> past = product(travel.past, turn.past);
  std::transform(past.begin() + 1, past.end(), std::back_inserter(wheel.from_own_past), std::negate<>{});
  std::vector<double>& own = left ? wheel.from_left : wheel.from_right;
  std::vector<double>& other = left ? wheel.from_right : wheel.from_left;
  for (std::size_t i = 0; i < by_travel.size(); ++i) {
    own.push_back(by_travel[i] + by_turn[i]);
    other.push_back(by_travel[i] - by_turn[i]);
  }
  return wheel;
}

WheelResponse response(const LinearPartShape& shape, const double* values, bool left, const OfOneWheel& of) {
  if (shape.has_modes()) return response_of_modes(shape, values, left, of);
  WheelResponse wheel;
  wheel.from_own_past.assign(values, values + shape.poles);
  std::vector<double>& own = left ? wheel.from_left : wheel.from_right;
  own.assign(values + shape.poles, values + shape.poles + shape.weights);
  if (shape.unequal_lags) own = delayed(own, of.lag_periods);
  own = scaled(own, of.gain);
  std::vector<double>& other = left ? wheel.from_right : wheel.from_left;
  other = cross_coupling_weights(shape, own, values + shape.poles + shape.weights);
  const std::size_t size = std::max(own.size(), other.size());
  own.resize(size, 0.0);
  other.resize(size, 0.0);
  return wheel;
}

}  // namespace

LinearModel TrialModel::linear() const {
  LinearModel model;
  model.type = ModelType::arma;
  model.period_s = period_s;
  model.wheel_base_m = wheel_base_m;
  const double half_lag = shape.unequal_lags ? 0.5 * linear_part[shape.of_wheels()] : 0.0;
  const double half_excess = 0.5 * excess_of_right();
  model.left = response(shape, linear_part.data(), true, {1.0 - half_excess, -half_lag});
  model.right = response(shape, linear_part.data() + (shape.shared ? 0 : shape.per_wheel()), false,
                         {1.0 + half_excess, half_lag});
  return model;
}

ModelSimulation TrialModel::simulation() const {
  std::vector<std::unique_ptr<Effect>> made;
  for (const auto& effect : acting()) made.push_back(effect.info->make({effect.parameters, effect.variant}));
  return {linear(), std::move(made)};
}

std::size_t TrialModel::parameter_count() const {
  std::size_t count = linear_part.size();
  for (const auto& effect : effects) count += effect.parameters.size();
  return count;
}

double TrialModel::parameter(std::size_t index) const {
  if (index < linear_part.size()) return linear_part[index];
  index -= linear_part.size();
  for (const auto& effect : effects) {
    if (index < effect.parameters.size()) return effect.parameters[index];
    index -= effect.parameters.size();
  }
  return 0.0;
}

double smallest_size(const ParameterInfo& info) {
  constexpr double without_sizes = 0.1;
  double smallest = 0.0;
  for (const double size : info.sizes) {
    if (size != 0.0 && (smallest == 0.0 || std::abs(size) < smallest)) smallest = std::abs(size);
  }
  return smallest > 0.0 ? smallest : without_sizes;
}

double typical_size(const TrialModel& model, std::size_t parameter) {
  constexpr double of_linear_part = 0.1;
  const ParameterInfo* info = model.parameter_info(parameter);
  return info == nullptr ? of_linear_part : smallest_size(*info);
}

double small_step(const TrialModel& model, std::size_t index) {
  const ParameterInfo* info = model.parameter_info(index);
  const double value = model.parameter(index);
  if (info == nullptr) return 1e-5;
  const double step = std::max(0.01 * std::abs(value), 0.02 * smallest_size(*info));
  return value + step > info->upper ? -step : step;
}

TrialEffect TrialEffect::within_bounds() const {
  TrialEffect effect = *this;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterInfo& info_of_one = parameter_info(i);
    effect.parameters[i] = std::clamp(parameters[i], info_of_one.lower, info_of_one.upper);
  }
  return effect;
}

void TrialModel::set_parameter(std::size_t index, double value) {
  if (index < linear_part.size()) {
    const bool of_gyro = shape.gyro_scaled && index == shape.gyro_index();
    linear_part[index] = of_gyro ? std::clamp(value, -largest_gyro_scale, largest_gyro_scale) : value;
    return;
  }
  index -= linear_part.size();
  for (auto& effect : effects) {
    if (index < effect.parameters.size()) {
      const ParameterInfo& info = effect.parameter_info(index);
      effect.parameters[index] = std::clamp(value, info.lower, info.upper);
      return;
    }
    index -= effect.parameters.size();
  }
}

const ParameterInfo* TrialModel::parameter_info(std::size_t index) const {
  if (index < linear_part.size()) return nullptr;
  index -= linear_part.size();
  for (const auto& effect : effects) {
    if (index < effect.parameters.size()) return &effect.parameter_info(index);
    index -= effect.parameters.size();
  }
  return nullptr;
}

TrialModel TrialModel::moved(const Eigen::VectorXd& step) const {
  TrialModel result = *this;
  for (std::size_t i = 0; i < parameter_count(); ++i) {
    result.set_parameter(i, parameter(i) + step(static_cast<Eigen::Index>(i)));
  }
  return result;
}

bool TrialModel::stable() const {
  const LinearModel model = linear();
  return std::max(largest_pole(model.left), largest_pole(model.right)) < largest_pole_allowed;
}

std::vector<EffectSetting> TrialModel::settings() const {
  std::vector<EffectSetting> settings;
  for (const auto& effect : effects) {
    settings.push_back({effect.info->name, effect.info->variants[effect.variant].name, effect.parameters});
  }
  return settings;
}

std::vector<TrialEffect> TrialModel::acting() const {
  std::vector<TrialEffect> acting = effects;
  std::stable_partition(acting.begin(), acting.end(), [](const TrialEffect& effect) {
    return effect.info->variants[effect.variant].acts_first;
  });
  return acting;
}

TrialModel first_guess(const LinearPartShape& shape, double period_s, double wheel_base_m, double lag_s,
                       double delay_s) {
  constexpr std::size_t default_poles = 2;
  if (shape.poles > default_poles) {
    LinearPartShape simpler = shape;
    simpler.poles -= 1;
    simpler.weights -= 1;
    return first_guess(simpler, period_s, wheel_base_m, lag_s, delay_s)
        .with_higher_order(simpler.poles == default_poles ? slow_pole(period_s) : 0.0);
  }
  TrialModel model{shape, period_s, wheel_base_m, std::vector<double>(shape.size(), 0.0), {}};
  const double pole = std::exp(-period_s / lag_s);
  const auto delay = std::min(static_cast<std::size_t>(std::lround(delay_s / period_s)), shape.weights - 1);
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    if (shape.poles > 0) model.linear_part[wheel] = pole;
    model.linear_part[wheel + shape.poles + delay] = shape.poles > 0 ? 1.0 - pole : 1.0;
  }
  return model;
}

}  // namespace wheelwright::gap

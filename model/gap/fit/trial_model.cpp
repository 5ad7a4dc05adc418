#include "model/gap/fit/trial_model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

namespace wheelwright::gap {
namespace {

constexpr double largest_pole_allowed = 0.995;

// Of a motor that creeps up to its speed.
double slow_pole(double period_s) {
  constexpr double creeping_s = 1.0;
  return std::exp(-period_s / creeping_s);
}

// Later by a part of a period, the gain being the same.
std::vector<double> delayed(const std::vector<double>& weights, double periods) {
  std::vector<double> later(weights.size() + 1, 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    later[i] += (1.0 - periods) * weights[i];
    later[i + 1] += periods * weights[i];
  }
  return later;
}

// Times 1 - pole z^-1.
std::vector<double> times_a_pole(const std::vector<double>& polynomial, double pole) {
  std::vector<double> product(polynomial.size() + 1, 0.0);
  for (std::size_t i = 0; i < polynomial.size(); ++i) {
    product[i] += polynomial[i];
    product[i + 1] -= pole * polynomial[i];
  }
  return product;
}

// The weights of the other wheel's command, where they are its own.
std::vector<double> cross_coupling_weights(const LinearPartShape& shape, const double* values) {
  std::vector<double> weights(values, values + shape.cross_coupling_size());
  if (shape.cross_coupling == CrossCoupling::balanced) {
    weights.push_back(-std::accumulate(weights.begin(), weights.end(), 0.0));
  }
  return weights;
}

// As parameters of a linear part of that cross coupling.
void add_cross_coupling_weights(std::vector<double>& linear_part, CrossCoupling cross_coupling,
                                const std::vector<double>& weights) {
  linear_part.insert(linear_part.end(), weights.begin(),
                     weights.end() - (cross_coupling == CrossCoupling::balanced ? 1 : 0));
}

// How one wheel departs from a response that both share.
struct OfOneWheel {
  double gain = 1.0;
  double lag_periods = 0.0;
};

WheelResponse response(const LinearPartShape& shape, const double* values, bool left, const OfOneWheel& of) {
  WheelResponse wheel;
  wheel.from_own_past.assign(values, values + shape.poles);
  std::vector<double>& own = left ? wheel.from_left : wheel.from_right;
  own.assign(values + shape.poles, values + shape.poles + shape.weights);
  if (shape.unequal_lags) own = delayed(own, of.lag_periods);
  for (double& weight : own) weight *= of.gain;
  std::vector<double>& other = left ? wheel.from_right : wheel.from_left;
  const double* cross_coupling = values + shape.poles + shape.weights;
  if (shape.crosses_by_weights()) {
    other = cross_coupling_weights(shape, cross_coupling);
    other.resize(own.size(), 0.0);
  } else {
    const double share = shape.cross_coupling == CrossCoupling::share ? *cross_coupling : 0.0;
    for (const double weight : own) other.push_back(share * weight);
  }
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

// Both sides of the difference equation times the same: the response stays what it is.
TrialModel TrialModel::with_higher_order(double pole) const {
  TrialModel larger = *this;
  larger.shape.poles += 1;
  larger.shape.weights += 1;
  larger.linear_part.clear();
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    const auto begin = linear_part.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto rest = weights + static_cast<std::ptrdiff_t>(shape.weights);
    std::vector<double> past{1.0};
    std::transform(begin, weights, std::back_inserter(past), std::negate<>{});
    past = times_a_pole(past, pole);
    std::transform(past.begin() + 1, past.end(), std::back_inserter(larger.linear_part), std::negate<>{});
    std::ranges::copy(times_a_pole({weights, rest}, pole), std::back_inserter(larger.linear_part));
    if (shape.cross_coupling == CrossCoupling::share) larger.linear_part.push_back(*rest);
    if (shape.crosses_by_weights()) {
      add_cross_coupling_weights(larger.linear_part, shape.cross_coupling,
                                 times_a_pole(cross_coupling_weights(shape, &*rest), pole));
    }
  }
  larger.linear_part.insert(larger.linear_part.end(),
                            linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                            linear_part.end());
  return larger;
}

TrialModel TrialModel::with_cross_coupling(CrossCoupling cross_coupling) const {
  TrialModel crossed = *this;
  crossed.shape.cross_coupling = cross_coupling;
  crossed.linear_part.clear();
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    const auto begin = linear_part.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto cross_couplings = begin + static_cast<std::ptrdiff_t>(shape.poles + shape.weights);
    crossed.linear_part.insert(crossed.linear_part.end(), begin, cross_couplings);
    if (shape.crosses_by_weights()) {
      add_cross_coupling_weights(crossed.linear_part, cross_coupling,
                                 cross_coupling_weights(shape, &*cross_couplings));
      continue;
    }
    const double share = shape.cross_coupling == CrossCoupling::share ? *cross_couplings : 0.0;
    for (std::size_t i = 0; i < crossed.shape.cross_coupling_size(); ++i) {
      crossed.linear_part.push_back(share * begin[static_cast<std::ptrdiff_t>(shape.poles + i)]);
    }
  }
  crossed.linear_part.insert(crossed.linear_part.end(),
                             linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                             linear_part.end());
  return crossed;
}

TrialModel TrialModel::with_later_linear_part(double delay_s) const {
  const auto whole = static_cast<std::size_t>(delay_s / period_s);
  const double rest = delay_s / period_s - static_cast<double>(whole);
  TrialModel later = *this;
  later.shape.weights += whole + 1;
  later.linear_part.clear();
  const auto put_off = [&](const std::vector<double>& weights) {
    std::vector<double> put(whole, 0.0);
    std::ranges::copy(delayed(weights, rest), std::back_inserter(put));
    return put;
  };
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    const auto begin = linear_part.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto cross_coupling = weights + static_cast<std::ptrdiff_t>(shape.weights);
    later.linear_part.insert(later.linear_part.end(), begin, weights);
    std::ranges::copy(put_off({weights, cross_coupling}), std::back_inserter(later.linear_part));
    if (shape.cross_coupling == CrossCoupling::share) later.linear_part.push_back(*cross_coupling);
    if (shape.crosses_by_weights()) {
      add_cross_coupling_weights(later.linear_part, shape.cross_coupling,
                                 put_off(cross_coupling_weights(shape, &*cross_coupling)));
    }
  }
  later.linear_part.insert(later.linear_part.end(),
                           linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                           linear_part.end());
  return later;
}

TrialModel TrialModel::with_delay_in_linear_part() const {
  const auto delay = std::ranges::find(effects, "transport_delay",
                                       [](const TrialEffect& effect) { return effect.info->name; });
  if (delay == effects.end()) return *this;
  TrialModel later = with_later_linear_part(delay->parameters[0]);
  later.effects.erase(later.effects.begin() + (delay - effects.begin()));
  return later;
}

TrialModel TrialModel::with_unequal_lags() const {
  TrialModel unequal_lags = *this;
  unequal_lags.shape.unequal_lags = true;
  unequal_lags.linear_part.insert(
      unequal_lags.linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_wheels()), 0.0);
  return unequal_lags;
}

TrialModel TrialModel::with_parted_linear_part() const {
  const LinearModel as_one = linear();
  TrialModel parted = *this;
  parted.shape.shared = parted.shape.unequal_lags = false;
  parted.shape.weights = as_one.left.from_left.size();
  parted.linear_part.clear();
  const auto add = [&](const std::vector<double>& past, const std::vector<double>& own,
                       const std::vector<double>& other) {
    std::ranges::copy(past, std::back_inserter(parted.linear_part));
    std::ranges::copy(own, std::back_inserter(parted.linear_part));
    if (shape.cross_coupling == CrossCoupling::share) parted.linear_part.push_back(share_of_other_wheel());
    if (shape.crosses_by_weights())
      add_cross_coupling_weights(parted.linear_part, shape.cross_coupling, other);
  };
  add(as_one.left.from_own_past, as_one.left.from_left, as_one.left.from_right);
  add(as_one.right.from_own_past, as_one.right.from_right, as_one.right.from_left);
  if (shape.reference_lag) parted.linear_part.push_back(reference_lag_s());
  if (shape.gyro_scaled) parted.linear_part.push_back(gyro_scale());
  return parted;
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

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
std::vector<double> crossing_weights(const CoreShape& shape, const double* values) {
  std::vector<double> weights(values, values + shape.crossing_size());
  if (shape.crossing == Crossing::balanced) {
    weights.push_back(-std::accumulate(weights.begin(), weights.end(), 0.0));
  }
  return weights;
}

// As parameters of a core of that crossing.
void add_crossing_weights(std::vector<double>& core, Crossing crossing, const std::vector<double>& weights) {
  core.insert(core.end(), weights.begin(), weights.end() - (crossing == Crossing::balanced ? 1 : 0));
}

// How one wheel departs from a response that both share.
struct OfOneWheel {
  double gain = 1.0;
  double lag_periods = 0.0;
};

WheelResponse response(const CoreShape& shape, const double* values, bool left, const OfOneWheel& of) {
  WheelResponse wheel;
  wheel.from_own_past.assign(values, values + shape.poles);
  std::vector<double>& own = left ? wheel.from_left : wheel.from_right;
  own.assign(values + shape.poles, values + shape.poles + shape.weights);
  if (shape.skewed) own = delayed(own, of.lag_periods);
  for (double& weight : own) weight *= of.gain;
  std::vector<double>& other = left ? wheel.from_right : wheel.from_left;
  const double* crossing = values + shape.poles + shape.weights;
  if (shape.crosses_by_weights()) {
    other = crossing_weights(shape, crossing);
    other.resize(own.size(), 0.0);
  } else {
    const double share = shape.crossing == Crossing::share ? *crossing : 0.0;
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
  const double half_lag = shape.skewed ? 0.5 * core[shape.of_wheels()] : 0.0;
  const double half_excess = 0.5 * excess_of_right();
  model.left = response(shape, core.data(), true, {1.0 - half_excess, -half_lag});
  model.right = response(shape, core.data() + (shape.shared ? 0 : shape.per_wheel()), false,
                         {1.0 + half_excess, half_lag});
  return model;
}

ModelSimulation TrialModel::simulation() const {
  std::vector<std::unique_ptr<Effect>> made;
  for (const auto& effect : acting()) made.push_back(effect.info->make({effect.parameters, effect.variant}));
  return {linear(), std::move(made)};
}

std::size_t TrialModel::parameter_count() const {
  std::size_t count = core.size();
  for (const auto& effect : effects) count += effect.parameters.size();
  return count;
}

double TrialModel::parameter(std::size_t index) const {
  if (index < core.size()) return core[index];
  index -= core.size();
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
  if (index < core.size()) {
    const bool of_gyro = shape.gyro_scaled && index == shape.gyro_index();
    core[index] = of_gyro ? std::clamp(value, -largest_gyro_scale, largest_gyro_scale) : value;
    return;
  }
  index -= core.size();
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
  if (index < core.size()) return nullptr;
  index -= core.size();
  for (const auto& effect : effects) {
    if (index < effect.parameters.size()) return &effect.parameter_info(index);
    index -= effect.parameters.size();
  }
  return nullptr;
}

bool TrialModel::stable() const {
  const LinearModel model = linear();
  return std::max(largest_pole(model.left), largest_pole(model.right)) < largest_pole_allowed;
}

// Both sides of the difference equation times the same: the response stays what it is.
TrialModel TrialModel::with_larger_core(double pole) const {
  TrialModel larger = *this;
  larger.shape.poles += 1;
  larger.shape.weights += 1;
  larger.core.clear();
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    const auto begin = core.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto rest = weights + static_cast<std::ptrdiff_t>(shape.weights);
    std::vector<double> past{1.0};
    std::transform(begin, weights, std::back_inserter(past), std::negate<>{});
    past = times_a_pole(past, pole);
    std::transform(past.begin() + 1, past.end(), std::back_inserter(larger.core), std::negate<>{});
    std::ranges::copy(times_a_pole({weights, rest}, pole), std::back_inserter(larger.core));
    if (shape.crossing == Crossing::share) larger.core.push_back(*rest);
    if (shape.crosses_by_weights()) {
      add_crossing_weights(larger.core, shape.crossing, times_a_pole(crossing_weights(shape, &*rest), pole));
    }
  }
  larger.core.insert(larger.core.end(), core.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                     core.end());
  return larger;
}

TrialModel TrialModel::with_crossed_core(Crossing crossing) const {
  TrialModel crossed = *this;
  crossed.shape.crossing = crossing;
  crossed.core.clear();
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    const auto begin = core.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto crossings = begin + static_cast<std::ptrdiff_t>(shape.poles + shape.weights);
    crossed.core.insert(crossed.core.end(), begin, crossings);
    if (shape.crosses_by_weights()) {
      add_crossing_weights(crossed.core, crossing, crossing_weights(shape, &*crossings));
      continue;
    }
    const double share = shape.crossing == Crossing::share ? *crossings : 0.0;
    for (std::size_t i = 0; i < crossed.shape.crossing_size(); ++i) {
      crossed.core.push_back(share * begin[static_cast<std::ptrdiff_t>(shape.poles + i)]);
    }
  }
  crossed.core.insert(crossed.core.end(), core.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                      core.end());
  return crossed;
}

TrialModel TrialModel::with_later_core(double delay_s) const {
  const auto whole = static_cast<std::size_t>(delay_s / period_s);
  const double rest = delay_s / period_s - static_cast<double>(whole);
  TrialModel later = *this;
  later.shape.weights += whole + 1;
  later.core.clear();
  const auto put_off = [&](const std::vector<double>& weights) {
    std::vector<double> put(whole, 0.0);
    std::ranges::copy(delayed(weights, rest), std::back_inserter(put));
    return put;
  };
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    const auto begin = core.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto crossing = weights + static_cast<std::ptrdiff_t>(shape.weights);
    later.core.insert(later.core.end(), begin, weights);
    std::ranges::copy(put_off({weights, crossing}), std::back_inserter(later.core));
    if (shape.crossing == Crossing::share) later.core.push_back(*crossing);
    if (shape.crosses_by_weights()) {
      add_crossing_weights(later.core, shape.crossing, put_off(crossing_weights(shape, &*crossing)));
    }
  }
  later.core.insert(later.core.end(), core.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                    core.end());
  return later;
}

TrialModel TrialModel::with_delay_in_core() const {
  const auto delay = std::ranges::find(effects, "transport_delay",
                                       [](const TrialEffect& effect) { return effect.info->name; });
  if (delay == effects.end()) return *this;
  TrialModel later = with_later_core(delay->parameters[0]);
  later.effects.erase(later.effects.begin() + (delay - effects.begin()));
  return later;
}

TrialModel TrialModel::with_skewed_core() const {
  TrialModel skewed = *this;
  skewed.shape.skewed = true;
  skewed.core.insert(skewed.core.begin() + static_cast<std::ptrdiff_t>(shape.of_wheels()), 0.0);
  return skewed;
}

TrialModel TrialModel::with_parted_core() const {
  const LinearModel as_one = linear();
  TrialModel parted = *this;
  parted.shape.shared = parted.shape.skewed = false;
  parted.shape.weights = as_one.left.from_left.size();
  parted.core.clear();
  const auto add = [&](const std::vector<double>& past, const std::vector<double>& own,
                       const std::vector<double>& other) {
    std::ranges::copy(past, std::back_inserter(parted.core));
    std::ranges::copy(own, std::back_inserter(parted.core));
    if (shape.crossing == Crossing::share) parted.core.push_back(share_of_other_wheel());
    if (shape.crosses_by_weights()) add_crossing_weights(parted.core, shape.crossing, other);
  };
  add(as_one.left.from_own_past, as_one.left.from_left, as_one.left.from_right);
  add(as_one.right.from_own_past, as_one.right.from_right, as_one.right.from_left);
  if (shape.reference_lag) parted.core.push_back(reference_lag_s());
  if (shape.gyro_scaled) parted.core.push_back(gyro_scale());
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
  std::stable_partition(acting.begin(), acting.end(),
                        [](const TrialEffect& effect) { return effect.info->acts_first; });
  return acting;
}

TrialModel first_guess(const CoreShape& shape, double period_s, double wheel_base_m, double lag_s,
                       double delay_s) {
  constexpr std::size_t usual_poles = 2;
  if (shape.poles > usual_poles) {
    CoreShape simpler = shape;
    simpler.poles -= 1;
    simpler.weights -= 1;
    return first_guess(simpler, period_s, wheel_base_m, lag_s, delay_s)
        .with_larger_core(simpler.poles == usual_poles ? slow_pole(period_s) : 0.0);
  }
  TrialModel model{shape, period_s, wheel_base_m, std::vector<double>(shape.size(), 0.0), {}};
  const double pole = std::exp(-period_s / lag_s);
  const auto delay = std::min(static_cast<std::size_t>(std::lround(delay_s / period_s)), shape.weights - 1);
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    if (shape.poles > 0) model.core[wheel] = pole;
    model.core[wheel + shape.poles + delay] = shape.poles > 0 ? 1.0 - pole : 1.0;
  }
  return model;
}

}  // namespace wheelwright::gap

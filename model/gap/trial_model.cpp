#include "model/gap/trial_model.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
namespace {

constexpr double largest_pole_allowed = 0.995;

WheelResponse response(const CoreShape& shape, const double* values, bool left) {
  WheelResponse wheel;
  wheel.from_own_past.assign(values, values + shape.poles);
  std::vector<double>& own = left ? wheel.from_left : wheel.from_right;
  own.assign(values + shape.poles, values + shape.poles + shape.weights);
  std::vector<double>& other = left ? wheel.from_right : wheel.from_left;
  const double share = shape.crossed ? values[shape.poles + shape.weights] : 0.0;
  for (const double weight : own) other.push_back(share * weight);
  return wheel;
}

}  // namespace

LinearModel TrialModel::linear() const {
  LinearModel model;
  model.type = ModelType::arma;
  model.period_s = period_s;
  model.wheel_base_m = wheel_base_m;
  model.left = response(shape, core.data(), true);
  model.right = response(shape, core.data() + (shape.shared ? 0 : shape.per_wheel()), false);
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

void TrialModel::set_parameter(std::size_t index, double value) {
  if (index < core.size()) {
    core[index] = value;
    return;
  }
  index -= core.size();
  for (auto& effect : effects) {
    if (index < effect.parameters.size()) {
      const ParameterInfo& info = effect.info->parameters[index];
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
    if (index < effect.parameters.size()) return &effect.info->parameters[index];
    index -= effect.parameters.size();
  }
  return nullptr;
}

bool TrialModel::stable() const {
  const LinearModel model = linear();
  return std::max(largest_pole(model.left), largest_pole(model.right)) < largest_pole_allowed;
}

TrialModel TrialModel::with_larger_core() const {
  TrialModel larger = *this;
  larger.shape.poles += 1;
  larger.shape.weights += 1;
  larger.core.clear();
  for (std::size_t wheel = 0; wheel < shape.of_wheels(); wheel += shape.per_wheel()) {
    const auto begin = core.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto rest = weights + static_cast<std::ptrdiff_t>(shape.weights);
    larger.core.insert(larger.core.end(), begin, weights);
    larger.core.push_back(0.0);
    larger.core.insert(larger.core.end(), weights, rest);
    larger.core.push_back(0.0);
    if (shape.crossed) larger.core.push_back(*rest);
  }
  if (shape.reference_lag) larger.core.push_back(core.back());
  return larger;
}

TrialModel TrialModel::with_crossed_core() const {
  TrialModel crossed = *this;
  crossed.shape.crossed = true;
  crossed.core.clear();
  for (std::size_t wheel = 0; wheel < shape.of_wheels(); wheel += shape.per_wheel()) {
    const auto begin = core.begin() + static_cast<std::ptrdiff_t>(wheel);
    crossed.core.insert(crossed.core.end(), begin, begin + static_cast<std::ptrdiff_t>(shape.per_wheel()));
    crossed.core.push_back(0.0);
  }
  if (shape.reference_lag) crossed.core.push_back(core.back());
  return crossed;
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
  TrialModel model{shape, period_s, wheel_base_m, std::vector<double>(shape.size(), 0.0), {}};
  const double pole = std::exp(-period_s / lag_s);
  const auto delay = std::min(static_cast<std::size_t>(std::lround(delay_s / period_s)), shape.weights - 1);
  for (std::size_t wheel = 0; wheel < shape.of_wheels(); wheel += shape.per_wheel()) {
    if (shape.poles > 0) model.core[wheel] = pole;
    model.core[wheel + shape.poles + delay] = shape.poles > 0 ? 1.0 - pole : 1.0;
  }
  return model;
}

}  // namespace wheelwright::gap

#include "model/filter/filter_noise.hpp"

#include <algorithm>

#include "model/effects/library/effect_library.hpp"

namespace wheelwright {
FilterNoise filter_noise_of(const RobotModel& model) {
  FilterNoise noise;
  if (model.encoder_scale) noise.scale_standard_error = model.encoder_scale->relative_standard_error;
  if (model.left_fit) {
    noise.position_noise_m.left = model.left_fit->position_noise_m;
    noise.drift_m_per_sqrt_s.left = model.left_fit->drift_m_per_sqrt_s;
    noise.gain_standard_error.left = std::max(min_gain_error, model.left_fit->gain_standard_error.from_left);
  }
  if (model.right_fit) {
    noise.position_noise_m.right = model.right_fit->position_noise_m;
    noise.drift_m_per_sqrt_s.right = model.right_fit->drift_m_per_sqrt_s;
    noise.gain_standard_error.right =
        std::max(min_gain_error, model.right_fit->gain_standard_error.from_right);
  }
  for (const AddedEffect& effect : model.effects) {
    const EffectInfo* info = find_effect(effect.setting.name);
    if (info == nullptr || !info->wheel_mismatch) continue;
    noise.wheel_mismatch = effect.intervals.empty() ? 0.0 : standard_deviation(effect.intervals.front());
  }
  return noise;
}

}  // namespace wheelwright

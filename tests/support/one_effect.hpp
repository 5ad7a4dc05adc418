// A robot that does at once what it is told, but for one effect, or a few.
#pragma once

#include <vector>

#include "model/simulation/model_simulation.hpp"

namespace wheelwright::test {

constexpr double one_effect_period_s = 0.018;
constexpr double one_effect_wheel_base_m = 0.258;

inline ModelSimulation only(const std::vector<EffectSetting>& effects) {
  const LinearModel linear_part{
      ModelType::arma, one_effect_period_s, one_effect_wheel_base_m, {{1.0}, {0.0}, {}}, {{0.0}, {1.0}, {}}};
  return {linear_part, effects};
}
inline ModelSimulation only(const EffectSetting& effect) {
  return only(std::vector{effect});
}

// Of the left wheel, once both have been told this for some periods.
inline double speed_after(ModelSimulation& simulation, double command_m_s, int periods) {
  double speed_m_s = 0.0;
  for (int k = 0; k < periods; ++k) speed_m_s = simulation.step({command_m_s, command_m_s}).wheel_m_s.left;
  return speed_m_s;
}

}  // namespace wheelwright::test

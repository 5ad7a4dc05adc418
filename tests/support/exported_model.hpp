// Models for tests of what is exported.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/simulation/robot_model.hpp"

namespace wheelwright::test {

// Wheels that settle at 0.9 and 1.1 of their commands.
inline RobotModel linear_model() {
  RobotModel model;
  model.robot = "a -- robot */";
  model.created = "2026-01-02T03:04:05Z";
  model.linear_part = {
      ModelType::arma, 0.018, 0.25, {{0.0, 0.18}, {0.0, 0.0}, {0.8}}, {{0.0, 0.0}, {0.0, 0.22}, {0.8}}};
  return model;
}

inline void add_effect(RobotModel& model, const std::string& name, const std::string& variant,
                       std::vector<double> parameters) {
  std::vector<ParameterInterval> intervals;
  for (const double value : parameters) intervals.push_back({value - 0.001, value + 0.002});
  model.effects.push_back(
      {{name, variant, std::move(parameters)}, intervals, {}, "2026-02-03T00:00:00Z", {}, {}});
}

inline RobotModel model_with_effects() {
  RobotModel model = linear_model();
  add_effect(model, "effective_track", "", {0.01});
  add_effect(model, "distance_scale", "", {0.02});
  add_effect(model, "wheel_scale_mismatch", "left_wheel", {0.04});
  add_effect(model, "saturation", "speed", {0.4, 0.0, 0.0});
  add_effect(model, "rate_limit", "speed", {0.8, 0.0});
  add_effect(model, "dead_zone", "", {0.03, 1.0});
  add_effect(model, "coulomb_friction", "", {0.012, 0.1});
  return model;
}

}  // namespace wheelwright::test

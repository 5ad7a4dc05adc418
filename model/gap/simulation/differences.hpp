// How a simulation differs from the robot: both are identified as models with effects, and these are held
// against each other.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/gap/conclusion/analysis_result.hpp"

namespace wheelwright::gap {

enum class DifferenceKind {
  missing,     // the robot has it and the simulation has not
  wrong_size,  // both have it, and some parameter differs by more than both intervals allow
  surplus,     // the simulation has it, and the robot would have shown it
  same,        // both have it, as far as these runs tell
  not_shown    // the simulation has it, and these runs of the robot could not show it
};
std::string_view kind_name(DifferenceKind kind);

// 95 % interval.
struct Known {
  double value = 0.0;
  ParameterInterval interval;
};

struct ParameterDifference {
  std::string name;
  std::string unit;
  std::optional<Known> simulation;  // nothing where it lacks the effect, or its form has no such parameter
  std::optional<Known> robot;
  bool differs = false;
};

struct EffectDifference {
  std::string effect;
  DifferenceKind kind = DifferenceKind::same;
  std::string simulation_form;  // of several that the effect has
  std::string robot_form;
  std::vector<ParameterDifference> parameters;
};

// Of all effects that either has. Sizes differ where the interval of their difference (half widths added in
// squares) leaves out zero, and by more than 3 % of the larger one; and where the robot's runs ask for it
// (needed_differences.hpp).
std::vector<EffectDifference> effect_differences(const GapAnalysis& simulation, const GapAnalysis& robot);

// As in "It lacks coulomb_friction (speed_loss 0.011 m/s [0.0106, 0.0111])."; empty where nothing differs.
std::string in_words(const std::vector<EffectDifference>& differences);

}  // namespace wheelwright::gap

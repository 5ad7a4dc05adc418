// The effects of a model as the C header holds them: which fragment says each, and by which numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/wheel_side.hpp"
#include "tools/wheelwright/export/c/c_fragment.hpp"
#include "tools/wheelwright/export/model_text.hpp"

namespace wheelwright::tools {

struct PlacedEffect {
  const AddedEffect* effect;  // of the model
  const CFragment* fragment;
  EffectStage stage;
  std::size_t variant;       // that of the fragment
  bool wheel_load_variants;  // it acts on the body, and the wheels feel it
  bool loads_motors;
  std::string state;                // the member that holds it; empty without one
  std::string numbers;              // the array of its parameters
  std::vector<std::size_t> places;  // of those in the effect's parameters
  EffectSetting setting;            // of the fragment: that of one wheel where it has a size for each
  std::optional<WheelSide> wheel;   // that alone feels it
};

struct PlacedEffects {
  std::vector<PlacedEffect> placed;  // in the order in which they act (ModelSimulation)
  std::vector<Unsaid> unsaid;
};

// One with a size for each wheel is placed twice, once for each.
PlacedEffects place_effects(const RobotModel& model);

}  // namespace wheelwright::tools

#include "tests/benchmark/sixth_plant/effects.hpp"

#include "tests/benchmark/plants/effect_table.hpp"

namespace plants::sixth {

std::vector<EffectEntry> named_effects() {
  return joined(
      {command_effects(), drive_effects(), wheel_effects(), floor_effects(), measurement_effects()});
}

std::vector<EffectEntry> outside_effects() {
  return joined({outside_command_effects(), outside_motion_effects()});
}

bool is_named(Effect effect) {
  return effect < Effect::supply_hiccup;
}

const EffectEntry& entry_of(Effect effect) {
  // In the order of the enumeration.
  static const std::vector<EffectEntry> entries = joined({named_effects(), outside_effects()});
  return entries[static_cast<std::size_t>(effect)];
}

}  // namespace plants::sixth

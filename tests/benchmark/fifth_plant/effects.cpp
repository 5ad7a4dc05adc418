#include "tests/benchmark/fifth_plant/effects.hpp"

#include "tests/benchmark/plants/effect_table.hpp"

namespace plants::fifth {

std::vector<Effect> all_effects() {
  return joined({command_effects(), drive_effects(), floor_effects(), body_effects()});
}

std::vector<Effect> outside_effects() {
  return joined({outside_drive_effects(), outside_place_effects(), outside_signal_effects()});
}

}  // namespace plants::fifth

#include "tests/benchmark/fourth_plant/effects.hpp"

#include "tests/benchmark/plants/effect_table.hpp"

namespace plants::fourth {

std::vector<Effect> all_effects() {
  return joined({command_effects(), drive_effects(), floor_effects(), body_effects()});
}

}  // namespace plants::fourth

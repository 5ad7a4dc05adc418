#include "tests/benchmark/second_plant/effects.hpp"

#include <cmath>

#include "tests/benchmark/plants/effect_table.hpp"

namespace plants::second {

double sized(double small_value, double large_value, double level) {
  return small_value * std::pow(large_value / small_value, level);
}

std::vector<Effect> all_effects() {
  return joined({command_effects(), drive_effects(), floor_effects()});
}

}  // namespace plants::second

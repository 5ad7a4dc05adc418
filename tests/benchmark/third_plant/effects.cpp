#include "tests/benchmark/third_plant/effects.hpp"

#include "tests/benchmark/plants/effect_table.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::third {

std::vector<Effect> all_effects() {
  return joined({command_effects(), drive_effects(), floor_effects()});
}

std::string millimetres(double length_m, int digits) {
  return fixed(1000.0 * length_m, digits) + " mm";
}

std::string per_cent(double share, int digits) {
  return fixed(100.0 * share, digits) + " %";
}

}  // namespace plants::third

#include "tests/benchmark/second_plant/effects.hpp"

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace second_plant {

double sized(double small_value, double large_value, double level) {
  return small_value * std::pow(large_value / small_value, level);
}

std::vector<Effect> all_effects() {
  std::vector<Effect> effects = command_effects();
  for (std::vector<Effect> group : {drive_effects(), floor_effects()})
    effects.insert(effects.end(), std::make_move_iterator(group.begin()),
                   std::make_move_iterator(group.end()));
  return effects;
}

const Effect& find_effect(const std::vector<Effect>& effects, const std::string& name) {
  for (const Effect& effect : effects)
    if (effect.name == name) return effect;
  throw std::invalid_argument("no effect called " + name);
}

}  // namespace second_plant

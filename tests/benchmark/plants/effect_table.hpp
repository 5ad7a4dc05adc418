// Tables of effects, of whatever type a plant describes its effects with.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

namespace plants {

template <typename Effect>
std::vector<Effect> joined(std::initializer_list<std::vector<Effect>> groups) {
  std::vector<Effect> effects;
  for (const std::vector<Effect>& group : groups) effects.insert(effects.end(), group.begin(), group.end());
  return effects;
}

template <typename Effect>
const Effect& find_effect(const std::vector<Effect>& effects, const std::string& name) {
  for (const Effect& effect : effects)
    if (effect.name == name) return effect;
  throw std::invalid_argument("no effect called " + name);
}

template <typename Effect>
std::vector<const Effect*> find_effects(const std::vector<Effect>& effects,
                                        const std::vector<std::string>& names) {
  std::vector<const Effect*> found;
  found.reserve(names.size());
  for (const std::string& name : names) found.push_back(&find_effect(effects, name));
  return found;
}

}  // namespace plants

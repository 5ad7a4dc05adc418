// The effects of a model file: the list below its key `effects`.
#pragma once

#include <string>
#include <vector>

#include "config/load/yaml_reader.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::config {

// Empty where the file has no effects. Throws ConfigError with the place for effects, variants and parameters
// that the library does not know or that are not possible.
std::vector<AddedEffect> read_effects(YamlReader& file);

// The section's text; empty without effects.
std::string effects_to_yaml(const std::vector<AddedEffect>& effects);

}  // namespace wheelwright::config

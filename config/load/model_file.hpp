// Models of a robot as files: YAML that a person can read, version 1 (`wheelwright_model: 1`).
//
// Everything of a RobotModel comes back exactly as it was saved. What a file must fulfil: keys that the
// format names and no others; finite numbers; command weights of equal length, at most 200 of them; a type
// `arma` that does not run away (largest pole below 1).
#pragma once

#include <filesystem>
#include <string>

#include "config/load/yaml_reader.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::config {

// Throws ConfigError with file, line and column for anything that is not as the format says.
RobotModel load_model(const std::filesystem::path& path);

// The same from a text; `name` stands for the file in messages.
RobotModel parse_model(const std::string& text, const std::string& name);

// The text of a model file, with comments for its reader.
std::string model_to_yaml(const RobotModel& model);

// Writes the file whole or not at all. Throws ConfigError where that fails, and for a model that load_model
// would refuse.
void save_model(const RobotModel& model, const std::filesystem::path& path);

}  // namespace wheelwright::config

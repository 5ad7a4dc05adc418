// Reads the description of a simulated robot from YAML (config/robots/*.yaml).
//
// The keys and their units are the members of simulation::SimulationConfig; what a file leaves out keeps its
// default. `based_on: FILE` starts from another file, so that a variant holds only what it changes; `room:
// FILE` takes the room from a file of its own. Both are relative to the file that names them.
#pragma once

#include <filesystem>

#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::config {

// Throws ConfigError with file, line and column for anything that is not as it should be, unknown keys
// included.
simulation::SimulationConfig load_simulation_config(const std::filesystem::path& path);

// Reads a room alone (config/robots/rooms/*.yaml).
simulation::RoomConfig load_room(const std::filesystem::path& path);

}  // namespace wheelwright::config

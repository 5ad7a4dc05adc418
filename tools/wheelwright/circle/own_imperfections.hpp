// What a simulated robot has of its own before anything is hidden in it.
#pragma once

#include <vector>

#include "drivers/simulation/simulation_config.hpp"
#include "tools/wheelwright/circle/hidden_robot.hpp"

namespace wheelwright::tools {

// All that differs from a robot without imperfections and has a name in the library, large enough for the
// library or not. Whoever names one of these is right, but nobody has to find it.
std::vector<Imperfection> own_imperfections(const simulation::SimulationConfig& robot);

}  // namespace wheelwright::tools

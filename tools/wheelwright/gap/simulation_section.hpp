// How a simulator differs from the robot, for programs and for a person.
#pragma once

#include <iosfwd>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tools/wheelwright/gap/compare_simulation.hpp"

namespace wheelwright::tools {

// `simulation` of gap.json: what the simulation was found to be, and each effect beside that of the robot.
nlohmann::ordered_json simulation_to_json(const ComparedSimulation& compared);

// A table of all effects of either.
void print_simulation(std::ostream& out, const ComparedSimulation& compared);

// The same for the page.
std::string simulation_section(const ComparedSimulation& compared);

}  // namespace wheelwright::tools

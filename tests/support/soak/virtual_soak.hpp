// Link, brain and simulated robot on the virtual clock, with a cable between them on which faults come one
// after the other; an operator who arms the robot again when it has been stopped; and what has to hold,
// checked at each tick.
#pragma once

#include <cstdint>
#include <functional>

#include "drivers/roomba/link_config.hpp"
#include "drivers/simulation/cable_fault.hpp"
#include "drivers/simulation/simulation_config.hpp"
#include "tests/support/soak/soak_figures.hpp"

namespace wheelwright::soak {

struct SoakConfig {
  simulation::SimulationConfig robot;
  roomba::LinkConfig link;
  simulation::CableFaultConfig cable;
  std::int64_t faults = 100;
  // Called after each fault that is over.
  std::function<void(std::int64_t faults)> progress = {};
};

SoakFigures run_virtual_soak(const SoakConfig& config);

}  // namespace wheelwright::soak

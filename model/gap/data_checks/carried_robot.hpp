// A robot that somebody lifts or pushes: its poses move while its wheels stand and no command moves them.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Says it, takes the poses on the way out, and lets what follows start again from the next pose. The robot
// has to have stood before, for half a second of commands of zero, without a count since; then it has to have
// moved by more than 0.1 m or 0.3 rad, and by ten times the noise of a pose.
void restart_where_carried(GateState& gate);

}  // namespace wheelwright::gap

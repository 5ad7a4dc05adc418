// A reference that stands still while the wheels roll: its source hung, repeats its last pose (perhaps with
// noise), or the robot was held.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Takes the poses out of segments in which the reference stands, and names each. Where that is most of the
// way the reference explains any gap.
void remove_frozen_reference(GateState& gate);

}  // namespace wheelwright::gap

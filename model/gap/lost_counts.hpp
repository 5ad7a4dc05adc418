// Counts that jump, are absent, stand still or miss edges: the rows are flagged, and dropouts noted.
#pragma once

#include "model/gap/gate_state.hpp"

namespace wheelwright::gap {

void find_jumps(GateState& gate);
void find_dropouts(GateState& gate);

}  // namespace wheelwright::gap

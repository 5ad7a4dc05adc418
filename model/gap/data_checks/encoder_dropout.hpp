// Counts that jump, are absent, stand still or miss edges: the rows are flagged, and dropouts noted.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

void find_jumps(GateState& gate);
void find_dropouts(GateState& gate);

// The log as it was before anybody knew that counts were lost: travel runs on over them. Jumps stay known.
DriveLog with_lost_counts(DriveLog log);

}  // namespace wheelwright::gap

// A reference that is written on every row, but comes less often: its last pose is repeated until the next.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Where the reference repeats itself to the last digit while the robot moves, only the first of equal poses
// is a reading; the others are left out, which is said with how often the reference comes.
void leave_out_repeated_poses(GateState& gate);

}  // namespace wheelwright::gap

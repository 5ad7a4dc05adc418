// A reference that goes otherwise than the wheels: its frame, its unit, and the numbers that people state of
// a robot.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Turns and travel of the reference against what odometry (or, without counts, the commands) say: another
// unit, a frame that is mirrored or turned; with counts a wheel base, or a distance of a count, that is wrong
// by more than any robot slips.
void check_reference(GateState& gate);

}  // namespace wheelwright::gap

// Signals that contradict each other: sides, signs, units and frames that cannot be as the log says. Such a
// fault explains a gap on its own.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Counters against commands.
void check_sides_and_signs(GateState& gate);
// A gyro against the counts. It explains nothing of the rest: one that contradicts them is left out.
void check_gyro(GateState& gate);

}  // namespace wheelwright::gap

// Steps of a reference that its robot did not make, and from which it does not come back: a map that is
// matched again, as of AMCL or SLAM.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Says how often, and how large, a reference steps where the counts do not: at least twice, by eight times
// the usual difference from one pose to the next, and half a metre or 5 rad a second faster than the wheels
// ever were in the run. Nothing is done about them: between its steps such a reference follows the counts, so
// that the steps hold what the counts miss.
void say_reference_steps(GateState& gate);

}  // namespace wheelwright::gap

// Steps of a reference that its robot did not make, and from which it does not come back: a map that is
// matched again, as of AMCL or SLAM.
#pragma once

#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Says how often, and how large, a reference steps where the counts do not: by eight times the usual
// difference from one pose to the next, and half a metre or 5 rad a second faster than the wheels ever were
// in the run. Of several steps nothing is done about them: between them such a reference follows the counts,
// so that they hold what the counts miss. Behind a single one, as where somebody runs into the robot, the
// free run starts again.
void treat_reference_steps(GateState& gate);

}  // namespace wheelwright::gap

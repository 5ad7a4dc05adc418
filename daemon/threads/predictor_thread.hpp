// The thread that runs the brain: frames in, commands and log entries out.
#pragma once

#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon {

// Runs until wiring.ending; does not allocate.
void run_predictor(Brain& brain, Wiring& wiring);

}  // namespace wheelwright::daemon

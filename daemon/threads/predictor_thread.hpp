// The thread that runs the brain: frames in, commands, log entries and its wish to stop out.
#pragma once

#include "daemon/wiring/wiring.hpp"
#include "drivers/roomba/sensor_loop.hpp"

namespace wheelwright::daemon {

// Runs until wiring.ending; does not allocate.
void run_predictor(Brain& brain, Wiring& wiring, roomba::SensorLoop& sensor_loop);

}  // namespace wheelwright::daemon

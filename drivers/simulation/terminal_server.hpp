// Runs a simulated robot on the wall clock, with its serial line on a pseudo-terminal.
#pragma once

#include <functional>
#include <optional>

#include "drivers/simulation/pseudo_terminal.hpp"
#include "drivers/simulation/simulated_robot.hpp"

namespace wheelwright::simulation {

struct TruthFile {
  int descriptor;  // open for writing; closed at the end
  double period_s;
};

// Serves until SIGTERM or SIGINT. SIGUSR1 takes the robot's battery out, and puts it in again the next time.
// Truth is written once per period: t,x,y,theta,speed_left,speed_right in s, m, rad, m/s, in the room's
// frame, with what else is known of the robot as `# key: value` lines before.
void serve_until_signal(SimulatedRobot& robot, PseudoTerminal& terminal,
                        const std::optional<TruthFile>& truth);

}  // namespace wheelwright::simulation

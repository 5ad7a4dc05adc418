// A run that a simulator wrote, as a drive log.
#pragma once

#include <iosfwd>

#include "model/log/drive_log.hpp"
#include "tools/wheelwright/gap/simulator.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

namespace wheelwright::tools {

// `real` is the robot's run whose commands the simulator was given. Where it writes no commands or no wheel
// base again, they are those that it was given. Throws UsageError for a run that ends early, diverges, stands
// still, or goes or turns ten times as far as its commands say (mm, degrees), and what `load_one_run` throws.
DriveLog load_simulated_run(const SimulatorRun& run, const DriveLog& real, const ImportOptions& options,
                            std::ostream& err);

// Of a run of a simulator that a person gave: throws UsageError where it diverges or stands still, and says
// on `err` where its motion ends before its commands do.
void check_simulation_run(const DriveLog& simulated, std::ostream& err);

}  // namespace wheelwright::tools

// The drives that a gap is looked for in.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "drivers/simulation/noise.hpp"
#include "model/brain/mission.hpp"
#include "model/log/drive_log.hpp"
#include "tools/wheelwright/evaluation/robot_trial.hpp"

namespace wheelwright::tools {

// A tour: checkpoints by chance, about `duration_s` long, within a square of 2 m that begins at the start.
Route random_tour(double speed_m_s, double duration_s, simulation::Noise& chance);

// Random drives and tours in turn, of about a minute each, so that the last third of them, which the gap
// workflow holds out, has some of both: random drives show the dynamics and go backwards, tours hold the
// speeds that routes are driven at. By `model` alone, with a reference pose on every row. Or why not, in one
// line.
tl::expected<std::vector<DriveLog>, std::string> learning_drives(std::size_t count, RobotTrial& trial,
                                                                 const RobotModel& model,
                                                                 simulation::Noise& chance);

struct ProofDrives {
  std::vector<DriveLog> logs;  // of those that came to their end
  std::size_t stopped = 0;     // that did not
  std::string failure;         // why the last of those did not
};

// The route itself once, and tours at its speed, of about a minute each, recorded alike: so many tours that
// came to their end, or what came of three times as many.
ProofDrives proof_drives(const Route& route, std::size_t tours, RobotTrial& trial, const RobotModel& model,
                         simulation::Noise& chance);

}  // namespace wheelwright::tools

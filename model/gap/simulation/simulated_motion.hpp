// A run of a simulator by the commands of a real run, held against that run as a model's free run is.
#pragma once

#include <span>
#include <vector>

#include "model/log/drive_log.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/score.hpp"

namespace wheelwright::gap {

// The simulated motion at each row of `real`, between rows of `simulated`; both begin with their first rows.
// Behind the end of `simulated` it stands still. Travel without counts, and poses without references, are
// zero.
std::vector<PredictedMotion> simulated_motion(const DriveLog& simulated, const DriveLog& real);

// The score of all runs, one simulated run for each real one. A figure is absent where either has not what it
// takes.
Score score_of_simulation(std::span<const DriveLog> simulated, std::span<const DriveLog> real);

}  // namespace wheelwright::gap

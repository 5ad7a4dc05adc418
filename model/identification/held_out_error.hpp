// How far a free run strays from the encoders, block by block.
#pragma once

#include <vector>

#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

// Mean square, in m^2, of the error of both wheels' travel since the start of each block. Blocks last about
// 5 s, or a sixth of what is judged where that is shorter; they begin at `from_s` at the earliest, and none
// reaches across a hole of the log or into the second after it. The free run starts at rest with the log.
std::vector<double> block_distance_squares(const LinearModel& model, const DriveLog& log, double from_s);

}  // namespace wheelwright

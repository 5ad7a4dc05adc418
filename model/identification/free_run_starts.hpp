// Where the refinement of a free run starts: it goes downhill, so it matters.
#pragma once

#include <span>
#include <vector>

#include "model/identification/arma_layout.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

// Both wheels' equations of the model that behaves like `fir` for the commands of the runs: eq. (12) with
// its free run, which carries no noise, in place of measured speeds (a model reduction). Noise in measured
// past speeds cannot bias it.
LinearModel reduce_to_arma(const LinearModel& fir, std::span<const DriveLog> logs, const ArmaLayout& layout);

// The same weights with all poles drawn towards zero, so far that the largest is at most 0.9: a usable start
// where the plain fit runs away.
WheelResponse drawn_to_stability(WheelResponse response);

}  // namespace wheelwright

// What a model answers to a step and to an impulse, beside what was measured.
#pragma once

#include <span>
#include <vector>

#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"
#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {

// Four pictures: step responses of v and of w to either motor, and the four transfer functions (eq. 2 to 10
// of the source paper). `actions` are the recordings of single steps from rest, one wheel each; with them the
// mean measured step response is drawn with its 95 % interval.
std::vector<Plot> response_plots(const LinearModel& model, std::span<const DriveLog> actions);

}  // namespace wheelwright::tools

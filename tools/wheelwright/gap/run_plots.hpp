// Pictures of runs beside free runs of a model, before and after something was added to it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"
#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {

// For each run: the error of each wheel's travel over time where it has counts, and of the heading where it
// has headings of a reference; the path on the floor, measured and by both models, where it has reference
// positions. Without `after` there is one model.
std::vector<Plot> run_plots(const RobotModel& before, const std::optional<RobotModel>& after,
                            std::span<const DriveLog> runs);

}  // namespace wheelwright::tools

// Pictures of single runs under two models, for the report: drawn by gnuplot, as SVG to be put into a page.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/drive_log.hpp"
#include "model/robot_model.hpp"

namespace wheelwright::tools {

struct Figure {
  std::string caption;
  std::string svg;  // takes the colours `currentColor`, `--before` and `--after` from the page around it
};

struct Figures {
  std::vector<Figure> figures;
  std::string problem;  // why there are none, in one line; empty where there are
};

// For each run: the error of each wheel's travel over time where it has counts; the path on the floor,
// measured and by both models, where it has reference positions. Without `after` there is one model.
Figures run_figures(const RobotModel& before, const std::optional<RobotModel>& after,
                    std::span<const DriveLog> runs);

}  // namespace wheelwright::tools

// The true motion of a simulated robot, in the frame of the route that it drove.
#pragma once

#include "config/load/csv_table.hpp"
#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {

struct TruePath {
  PlotPoints points;       // as seen from where the route began
  double closure_m = 0.0;  // from there to the end
};

// The route begins where the last stand of at least 0.9 s ends after which the robot moved. Throws
// config::LogError where columns are missing.
TruePath true_path(const config::CsvTable& truth);

}  // namespace wheelwright::tools

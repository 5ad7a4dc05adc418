// What a model leaves, tabulated over the one quantity that it hangs on the most: the picture of an effect
// that has no name. It is a correction that could be read off, not an explanation.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

struct ResidualRow {
  double from = 0.0;  // range of the quantity
  double to = 0.0;
  double mean = 0.0;  // measured minus predicted
  double ci95 = 0.0;  // half width of its 95 % interval, by sums over blocks of time
  double share_of_time = 0.0;
};

struct ResidualTable {
  std::string residual;  // "wheel speed", "turn rate by the wheels", "turn rate by the reference"
  std::string residual_unit;
  std::string over;  // the quantity, as a person says it: "own command"
  std::string over_unit;
  double explained = 0.0;  // share of the residual's variance that lies between the rows
  std::vector<ResidualRow> rows;
};

// Speeds are means over a quarter of a second of the model's free run. Nothing where the logs hold neither
// counts nor headings, or no two rows differ by more than chance.
std::optional<ResidualTable> residual_table(const RobotModel& model, std::span<const GatedLog> logs);

}  // namespace wheelwright::gap

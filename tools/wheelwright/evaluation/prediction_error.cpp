#include "tools/wheelwright/evaluation/prediction_error.hpp"

#include <vector>

#include "model/prediction/open_loop_runs.hpp"
#include "model/prediction/score.hpp"

namespace wheelwright::tools {

std::optional<double> position_error_m(const RobotModel& model, std::span<const DriveLog> logs) {
  ScoreSums sums;
  for (const DriveLog& log : logs) {
    const auto motions = open_loop_runs(model, log);
    const std::vector<Prediction> predictions(motions.begin(), motions.end());
    sums.add(predictions, log);
  }
  const auto error = sums.score().position_rms_m;
  return error ? std::optional(error->value) : std::nullopt;
}

}  // namespace wheelwright::tools

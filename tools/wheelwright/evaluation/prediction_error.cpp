#include "tools/wheelwright/evaluation/prediction_error.hpp"

#include <cmath>

#include "model/prediction/free_run.hpp"

namespace wheelwright::tools {

std::optional<double> position_error_m(const RobotModel& model, std::span<const DriveLog> logs) {
  double squares_m2 = 0.0;
  std::size_t count = 0;
  for (const DriveLog& log : logs) {
    const auto motion = free_run(model, log);
    for (std::size_t k = 0; k < log.samples.size(); ++k) {
      const DriveSample& sample = log.samples[k];
      if (!sample.reference_x_m || !sample.reference_y_m) continue;
      squares_m2 += std::pow(motion[k].pose.x_m - *sample.reference_x_m, 2) +
                    std::pow(motion[k].pose.y_m - *sample.reference_y_m, 2);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(squares_m2 / static_cast<double>(count));
}

}  // namespace wheelwright::tools

#include "daemon/recording/calibration_remarks.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace wheelwright::daemon {

std::optional<std::string> remark_on_scale(const EncoderScaleFit& fit, const config::DaemonConfig& config) {
  constexpr double usual = 0.05;
  const double mean_m = 0.5 * (fit.metres_per_tick.left + fit.metres_per_tick.right);
  const double nominal_m = config.limits.metres_per_tick.left;
  const double off = mean_m / nominal_m - 1.0;
  if (std::abs(off) < usual) return std::nullopt;
  return fmt::format(
      "a count is {:.1f} % {} than robot.nominal_metres_per_tick: look whether robot.wheel_base_m, {} m, is "
      "that "
      "of the robot, by which all lengths are scaled, and whether both encoders count",
      100.0 * std::abs(off), off > 0.0 ? "longer" : "shorter", config.limits.wheel_base_m);
}

std::optional<std::string> remark_on_wheels(const RobotModel& model) {
  constexpr double usual = 0.04;
  constexpr double sure = 4.0;  // standard errors
  if (!model.left_fit || !model.right_fit) return std::nullopt;
  const double left = model.left_fit->gain.from_left;
  const double right = model.right_fit->gain.from_right;
  const double error = std::hypot(model.left_fit->gain_standard_error.from_left,
                                  model.right_fit->gain_standard_error.from_right);
  const double apart = std::abs(left - right);
  const double share = apart / std::max(left, right);
  if (!(share > usual) || apart < sure * error) return std::nullopt;
  return fmt::format(
      "the {} wheel goes {:.1f} % less far per command than the other, by its counts: look whether it drags "
      "or "
      "its encoder loses counts, of which the model knows nothing",
      left < right ? "left" : "right", 100.0 * share);
}

}  // namespace wheelwright::daemon

#include "tools/wheelwright/export/ros2_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/export/drive_figures.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::array<std::string_view, 8> ros2_put{
    "distance_scale", "wheel_scale_mismatch", "effective_track", "saturation", "rate_limit",
    "dead_zone",      "coulomb_friction",     "stiction"};

constexpr std::array<UnsaidReason, 18> ros2_reasons{{
    {"acceleration_slip", "odometry takes wheels to roll without slip; limit acceleration to its grip"},
    {"asymmetric_response",
     "the controller commands speeds at once; how the wheel follows is the drive's own"},
    {"backlash", "odometry counts what the encoder turns; there is no parameter for play"},
    {"caster_kick", "there is no disturbance on the body"},
    {"command_quantization", "commands are continuous there"},
    {"direction_gain", "one radius multiplier holds for both directions"},
    {"encoder_dropout", "there is no fault model of the encoders"},
    {"floor_slope", "speed does not depend on heading there"},
    {"gain_curve", "commands and speeds are in proportion there"},
    {"gain_drift", "parameters do not change with time"},
    {"lever_arm", "the controller has no outside reference; it belongs into the transform to the sensor"},
    {"surface_patch", "parameters do not change with place"},
    {"transport_delay", "there is no parameter for a delay of commands"},
    {"turn_scrub", "one separation multiplier holds for all turn rates"},
    {"turn_speed_loss", "speed does not depend on turn rate there"},
    {"voltage_sag", "parameters do not change with the battery's voltage"},
    {"wheel_eccentricity", "wheels are round there"},
    {"yaw_bias", "there is no constant turn rate to add"},
}};

std::string line(const std::string& indent, const std::string& key, const std::string& value,
                 const std::string& remark) {
  return indent + key + ": " + value + (remark.empty() ? "" : "  # " + remark) + "\n";
}

// Readers of YAML take a number without a point for an integer or a text.
std::string real(double value) {
  std::string text = short_number(value);
  if (text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string limits(const std::string& axis, const std::string& part, const std::optional<Figure>& speed,
                   const std::optional<Figure>& change) {
  if (!speed && !change) return "";
  const std::string indent = "        ";
  std::string text = "    " + axis + ":\n      " + part + ":\n";
  const auto add = [&](const std::string& quantity, const std::optional<Figure>& figure) {
    if (!figure) return;
    text += line(indent, "has_" + quantity + "_limits", "true", "");
    text += line(indent, "max_" + quantity, real(figure->value), remark_of(*figure));
    text += line(indent, "min_" + quantity, real(-figure->value), "");
  };
  add("velocity", speed);
  add("acceleration", change);
  return text;
}

std::string triple(double x, double theta) {
  return "[" + real(x) + ", 0.0, " + real(theta) + "]";
}

// The walk of the wheels' way, in one second.
std::string covariance(const RobotModel& model) {
  if (!model.left_fit || !model.right_fit) {
    return "    # pose_covariance_diagonal: the model file holds no drift of the wheels' way (fit --type fir "
           "measures it)\n";
  }
  const double left = std::pow(model.left_fit->drift_m_per_sqrt_s, 2);
  const double right = std::pow(model.right_fit->drift_m_per_sqrt_s, 2);
  const std::string along = real((left + right) / 4.0);
  const std::string turn = real((left + right) / std::pow(model.linear_part.wheel_base_m, 2));
  return "    # What odometry gains in one second, as the wheels' drift was measured; across, as along.\n" +
         line("    ", "pose_covariance_diagonal",
              "[" + along + ", " + along + ", 0.0, 0.0, 0.0, " + turn + "]", "");
}

std::string smoother(const DriveFigures& figures, double turn_per_speed) {
  if (!figures.largest_speed_m_s && !figures.largest_change_m_s2 && !figures.smallest_command_m_s) return "";
  std::string text = "velocity_smoother:\n  ros__parameters:\n";
  const auto add = [&](const std::string& key, const Figure& along) {
    text += line("    ", key, triple(along.value, along.value * turn_per_speed), "x: " + remark_of(along));
  };
  if (figures.largest_speed_m_s) {
    add("max_velocity", *figures.largest_speed_m_s);
    add("min_velocity", scaled(*figures.largest_speed_m_s, -1.0));
  }
  if (figures.largest_change_m_s2) {
    add("max_accel", *figures.largest_change_m_s2);
    add("max_decel", scaled(*figures.largest_change_m_s2, -1.0));
  }
  if (figures.smallest_command_m_s) add("deadband_velocity", *figures.smallest_command_m_s);
  return text;
}

std::string head(const RobotModel& model, const DriveFigures& figures, const std::vector<Unsaid>& unsaid) {
  std::string text = "# wheelwright_ros2_control: 1\n# " + origin_of(model) +
                     "\n# diff_drive_controller of ros2_control, and velocity_smoother of Nav2.\n"
                     "# Of the linear part there is no place for its gain (left " +
                     short_number(figures.gain.left) + ", right " + short_number(figures.gain.right) +
                     ") and its delay (" + config::fixed_number(figures.lag_s.left, 3) + " s, " +
                     config::fixed_number(figures.lag_s.right, 3) + " s).\n";
  for (const auto& [effect, reason] : unsaid)
    text += "# " + effect + ": cannot be said in this format: " + reason + "\n";
  return text;
}

}  // namespace

ModelText to_ros2_control(const RobotModel& model, double wheel_radius_m) {
  const DriveFigures figures = drive_figures(model);
  std::vector<Unsaid> unsaid = unsaid_of(model, ros2_put, ros2_reasons);
  // Turning on the spot, wheels of that speed turn the robot by so much.
  const double turn_per_speed = 2.0 / (figures.wheel_separation_m * figures.separation_multiplier.value);
  const auto turning = [turn_per_speed](const std::optional<Figure>& figure) {
    return figure ? std::optional(scaled(*figure, turn_per_speed)) : std::nullopt;
  };
  std::string text = head(model, figures, unsaid) + "diff_drive_controller:\n  ros__parameters:\n";
  const auto add = [&text](const std::string& key, const Figure& figure) {
    text += line("    ", key, real(figure.value), remark_of(figure));
  };
  text += line("    ", "wheel_separation", real(figures.wheel_separation_m), "as the logs give it");
  text += line("    ", "wheel_radius", real(wheel_radius_m), "as it was given");
  add("wheel_separation_multiplier", figures.separation_multiplier);
  add("left_wheel_radius_multiplier", figures.left_radius_multiplier);
  add("right_wheel_radius_multiplier", figures.right_radius_multiplier);
  text += covariance(model);
  text += limits("linear", "x", figures.largest_speed_m_s, figures.largest_change_m_s2);
  text += limits("angular", "z", turning(figures.largest_speed_m_s), turning(figures.largest_change_m_s2));
  text += smoother(figures, turn_per_speed);
  return {std::move(text), std::move(unsaid)};
}

}  // namespace wheelwright::tools

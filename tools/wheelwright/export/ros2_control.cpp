#include "tools/wheelwright/export/ros2_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/export/yaml_lines.hpp"

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

// Along `axis`, as "linear.x".
void add_limits(std::vector<PlacedNumber>& numbers, const std::string& axis, const std::string& unit,
                const std::optional<Figure>& speed, const std::optional<Figure>& change) {
  const auto add_both = [&](const std::string& quantity, const std::optional<Figure>& figure,
                            const std::string& of) {
    if (!figure) return;
    const std::string end = "_" + quantity;
    numbers.push_back(keyword(Part::controller, axis + ".has" + end + "_limits", "true"));
    numbers.push_back(limit(Part::controller, axis + ".max" + end, {*figure}, of, remark_of(*figure)));
    numbers.push_back(limit(Part::controller, axis + ".min" + end, {scaled(*figure, -1.0)}, of, ""));
  };
  add_both("velocity", speed, unit + "/s");
  add_both("acceleration", change, unit + "/s^2");
}

// What odometry gains in one second: the walk of the wheels' way; across, as along.
void add_covariance(std::vector<PlacedNumber>& numbers, const RobotModel& model) {
  if (!model.left_fit || !model.right_fit) return;
  const double left = std::pow(model.left_fit->drift_m_per_sqrt_s, 2);
  const double right = std::pow(model.right_fit->drift_m_per_sqrt_s, 2);
  const Figure none{};
  const Figure along{(left + right) / 4.0, {}, ""};
  const Figure turn{(left + right) / std::pow(model.linear_part.wheel_base_m, 2), {}, ""};
  PlacedNumber covariance =
      measured(Part::controller, "pose_covariance_diagonal", {along, along, none, none, none, turn},
               "m^2,m^2,m^2,rad^2,rad^2,rad^2",
               "x, y and yaw: gained in one second, as the wheels' drift was measured; across, as along");
  covariance.unknown = {2, 3, 4};
  numbers.push_back(std::move(covariance));
}

// Along x, and turning on the spot; there is no y.
PlacedNumber triple(const std::string& key, const Figure& along, double turn_per_speed,
                    const std::string& unit) {
  PlacedNumber number = measured(Part::smoother, key, {along, Figure{}, scaled(along, turn_per_speed)},
                                 "m/" + unit + ",m/" + unit + ",rad/" + unit, "x: " + remark_of(along));
  number.unknown = {1};
  return number;
}

void add_smoother(std::vector<PlacedNumber>& numbers, const DriveFigures& figures, double turn_per_speed) {
  const auto add_limits = [&](const std::string& most, const std::string& least,
                              const std::optional<Figure>& along, const std::string& unit) {
    if (!along) return;
    for (const auto& [key, figure] : {std::pair{most, *along}, std::pair{least, scaled(*along, -1.0)}}) {
      numbers.push_back(triple(key, figure, turn_per_speed, unit));
      numbers.back().is_limit = true;
    }
  };
  add_limits("max_velocity", "min_velocity", figures.largest_speed_m_s, "s");
  add_limits("max_accel", "max_decel", figures.largest_change_m_s2, "s^2");
  if (figures.smallest_command_m_s)
    numbers.push_back(triple("deadband_velocity", *figures.smallest_command_m_s, turn_per_speed, "s"));
}

std::string head(const RobotModel& model, const ModelNumbers& all) {
  std::string text = "# wheelwright_ros2_control: 1\n# " + origin_of(model) +
                     "\n# diff_drive_controller of ros2_control, and velocity_smoother of Nav2.\n# " +
                     all.notes + "\n";
  for (const auto& [effect, reason] : all.unsaid)
    text += "# " + effect + ": cannot be said in this format: " + reason + "\n";
  return text;
}

std::string node(const std::string& name, const std::vector<PlacedNumber>& numbers) {
  if (numbers.empty()) return "";
  std::vector<YamlLine> lines;
  std::ranges::transform(numbers, std::back_inserter(lines), yaml_line);
  return name + ":\n  ros__parameters:\n" + yaml_lines(lines, "    ", "  ", "\n");
}

}  // namespace

ModelNumbers ros2_control_numbers(const RobotModel& model, double wheel_radius_m) {
  const DriveFigures figures = drive_figures(model);
  // Turning on the spot, wheels of that speed turn the robot by so much.
  const double turn_per_speed = 2.0 / (figures.wheel_separation_m * figures.separation_multiplier.value);
  const auto turning = [turn_per_speed](const std::optional<Figure>& figure) {
    return figure ? std::optional(scaled(*figure, turn_per_speed)) : std::nullopt;
  };
  ModelNumbers result;
  const auto add_controller = [&result](const std::string& key, const Figure& figure, const std::string& unit,
                                        const std::string& remark) {
    result.numbers.push_back(measured(Part::controller, key, {figure}, unit, remark));
  };
  add_controller("wheel_separation", Figure{figures.wheel_separation_m, {}, ""}, "m", "as the logs give it");
  add_controller("wheel_radius", Figure{wheel_radius_m, {}, ""}, "m", "as it was given");
  for (const auto& [key, multiplier] :
       {std::pair{"wheel_separation_multiplier", figures.separation_multiplier},
        std::pair{"left_wheel_radius_multiplier", figures.left_radius_multiplier},
        std::pair{"right_wheel_radius_multiplier", figures.right_radius_multiplier}}) {
    add_controller(key, multiplier, "1", remark_of(multiplier));
  }
  add_covariance(result.numbers, model);
  add_limits(result.numbers, "linear.x", "m", figures.largest_speed_m_s, figures.largest_change_m_s2);
  add_limits(result.numbers, "angular.z", "rad", turning(figures.largest_speed_m_s),
             turning(figures.largest_change_m_s2));
  add_smoother(result.numbers, figures, turn_per_speed);
  result.unsaid = unsaid_of(model, ros2_put, ros2_reasons);
  result.notes = "Of the linear part there is no place for its gain (left " + nine_digits(figures.gain.left) +
                 ", right " + nine_digits(figures.gain.right) + ") and its delay (" +
                 config::fixed_number(figures.left_response.mean_delay_s, 3) + " s, " +
                 config::fixed_number(figures.right_response.mean_delay_s, 3) + " s)." +
                 (model.left_fit && model.right_fit
                      ? ""
                      : " The model file holds no drift of the wheels' way for pose_covariance_diagonal (fit "
                        "--type fir measures it).");
  return result;
}

ModelText to_ros2_control(const RobotModel& model, double wheel_radius_m) {
  ModelNumbers all = ros2_control_numbers(model, wheel_radius_m);
  std::string text = head(model, all) +
                     node("diff_drive_controller", numbers_of(all.numbers, Part::controller)) +
                     node("velocity_smoother", numbers_of(all.numbers, Part::smoother));
  return {std::move(text), std::move(all.unsaid)};
}

}  // namespace wheelwright::tools

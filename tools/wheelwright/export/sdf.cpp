#include "tools/wheelwright/export/sdf.hpp"

#include <array>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/export/xml_text.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::array<std::string_view, 4> sdf_put{"distance_scale", "effective_track", "saturation",
                                                  "rate_limit"};
constexpr std::array<std::string_view, 6> sdf_put_with_torque{
    "distance_scale", "effective_track", "saturation", "rate_limit", "coulomb_friction", "stiction"};

constexpr std::array<UnsaidReason, 22> sdf_reasons{{
    {"acceleration_slip",
     "slip results from the contact of wheel and ground, which has no parameter in acceleration"},
    {"asymmetric_response", "the plugin sets speeds at once, both ways alike"},
    {"backlash", "a joint has no play"},
    {"caster_kick", "it results from the caster's own links and joints, where the world has one"},
    {"command_quantization", "commands of the plugin are continuous"},
    {"coulomb_friction",
     "joints take torques and the model knows speeds; export it with the inertia of a wheel"},
    {"dead_zone", "the plugin passes every command"},
    {"direction_gain", "the plugin has one gain, 1, both ways"},
    {"encoder_dropout", "joint states have no faults"},
    {"floor_slope", "it is a property of the world: tilt its ground"},
    {"gain_curve", "commands and speeds of the plugin are in proportion"},
    {"gain_drift", "parameters do not change with time"},
    {"lever_arm", "it belongs into the pose of the sensor's link"},
    {"stiction", "joints take torques and the model knows speeds; export it with the inertia of a wheel"},
    {"surface_patch", "it is a property of the world: give that place a surface of its own"},
    {"transport_delay", "the plugin acts on a command at once"},
    {"turn_scrub", "it results from the contact of wheel and ground, and has no parameter in turn rate"},
    {"turn_speed_loss", "it results from the contact of wheel and ground, and has no parameter in turn rate"},
    {"voltage_sag", "the plugin has no supply voltage"},
    {"wheel_eccentricity", "the plugin's wheels are round; move the axle in the wheel's own link"},
    {"wheel_scale_mismatch", "the plugin has one radius for both wheels"},
    {"yaw_bias", "the plugin adds no turn rate"},
}};

void add_limits(std::vector<PlacedNumber>& numbers, const std::string& quantity, const std::string& unit,
                const Figure& figure) {
  numbers.push_back(measured(Part::drive_plugin, "max_" + quantity, {figure}, unit, remark_of(figure)));
  numbers.push_back(measured(Part::drive_plugin, "min_" + quantity, {scaled(figure, -1.0)}, unit, ""));
}

// Of forward motion and of turning on the spot.
void add_limits(std::vector<PlacedNumber>& numbers, const std::string& quantity, const std::string& per,
                const std::optional<Figure>& figure, double separation_m) {
  if (!figure) return;
  add_limits(numbers, "linear_" + quantity, "m/" + per, *figure);
  add_limits(numbers, "angular_" + quantity, "rad/" + per, scaled(*figure, 2.0 / separation_m));
}

// The plugin turns the wheels by its two numbers, and the links say how far that takes the robot. The links
// stay as they are; so a robot that turns less than its wheel base says gets a smaller separation, and one
// that goes further a smaller radius.
void add_plugin(std::vector<PlacedNumber>& numbers, const DriveFigures& figures, const WheelGeometry& wheel) {
  const double base_m = figures.wheel_separation_m;
  const Figure track_m = scaled(figures.separation_multiplier, base_m);
  const Figure separation_m = divided_by(base_m, figures.separation_multiplier);
  const Figure rolls = mean_of(figures.left_radius_multiplier, figures.right_radius_multiplier);
  const Figure radius_m = divided_by(wheel.radius_m, rolls);
  numbers.push_back(measured(Part::drive_plugin, "wheel_separation", {separation_m}, "m",
                             "with wheels " + nine_digits(base_m) +
                                 " m apart the robot turns as one whose wheels are " + value_of(track_m) +
                                 " m apart: " + remark_of(separation_m)));
  numbers.push_back(measured(
      Part::drive_plugin, "wheel_radius", {radius_m}, "m",
      "with wheels of " + nine_digits(wheel.radius_m) + " m, which go as far as such of left " +
          value_of(scaled(figures.left_radius_multiplier, wheel.radius_m)) + " m and right " +
          value_of(scaled(figures.right_radius_multiplier, wheel.radius_m)) + " m: " + remark_of(radius_m)));
  add_limits(numbers, "velocity", "s", figures.largest_speed_m_s, base_m);
  add_limits(numbers, "acceleration", "s^2", figures.largest_change_m_s2, base_m);
}

void add_joint(std::vector<PlacedNumber>& numbers, Part joint, const WheelTorque& torque, double lag_s) {
  numbers.push_back(
      measured(joint, "damping", {Figure{torque.damping_n_m_s, {}, ""}}, "N m/(rad/s)",
               "for a joint that is driven by torque: lag " + config::fixed_number(lag_s, 3) + " s"));
  numbers.push_back(measured(joint, "friction", {torque.friction_n_m}, "N m", torque.friction_remark));
}

std::string elements(const std::vector<PlacedNumber>& numbers) {
  std::string text;
  for (const PlacedNumber& number : numbers) {
    text += xml_remarks("  ", {number}) + "  <" + number.key + ">" + value_text(number) + "</" + number.key +
            ">\n";
  }
  return text;
}

std::string dynamics(const std::vector<PlacedNumber>& numbers, const std::string& side) {
  if (numbers.empty()) return "";
  return "<!-- Into <axis> of " + side + "_wheel_joint. -->\n<dynamics>\n" + elements(numbers) +
         "</dynamics>\n";
}

}  // namespace

ModelNumbers sdf_numbers(const RobotModel& model, const WheelGeometry& wheel) {
  const DriveFigures figures = drive_figures(model);
  const double left_s = figures.left_response.mean_delay_s;
  const double right_s = figures.right_response.mean_delay_s;
  const auto left = wheel_torque(figures.left_limits, left_s, wheel);
  const auto right = wheel_torque(figures.right_limits, right_s, wheel);
  const bool torques = left && right;
  ModelNumbers result;
  add_plugin(result.numbers, figures, wheel);
  if (torques) {
    add_joint(result.numbers, Part::left_joint, *left, left_s);
    add_joint(result.numbers, Part::right_joint, *right, right_s);
  }
  result.unsaid =
      torques ? unsaid_of(model, sdf_put_with_torque, sdf_reasons) : unsaid_of(model, sdf_put, sdf_reasons);
  result.notes = "Of the linear part the plugin has no place for its gain (left " +
                 nine_digits(figures.gain.left) + ", right " + nine_digits(figures.gain.right) + ")" +
                 (torques ? "." : " and its delay; dynamics of the joints take the inertia of a wheel.");
  return result;
}

ModelText to_sdf(const RobotModel& model, const WheelGeometry& wheel) {
  ModelNumbers all = sdf_numbers(model, wheel);
  const auto of = [&all](Part part) { return numbers_of(all.numbers, part); };
  return {
      xml_head("wheelwright_sdf", model, all) +
          "<plugin filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\">\n"
          "  <left_joint>left_wheel_joint</left_joint>\n  <right_joint>right_wheel_joint</right_joint>\n" +
          elements(of(Part::drive_plugin)) + "</plugin>\n" + dynamics(of(Part::left_joint), "left") +
          dynamics(of(Part::right_joint), "right"),
      std::move(all.unsaid)};
}

}  // namespace wheelwright::tools

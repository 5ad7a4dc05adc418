#include "tools/wheelwright/export/sdf.hpp"

#include <algorithm>
#include <array>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::array<std::string_view, 4> sdf_put{"distance_scale", "effective_track", "saturation",
                                                  "rate_limit"};
constexpr std::array<std::string_view, 6> sdf_put_with_torque{
    "distance_scale", "effective_track", "saturation", "rate_limit", "coulomb_friction", "stiction"};

constexpr std::array<UnsaidReason, 22> sdf_reasons{{
    {"acceleration_slip",
     "slip comes of the contact of wheel and ground, which has no parameter in acceleration"},
    {"asymmetric_response", "the plugin sets speeds at once, both ways alike"},
    {"backlash", "a joint has no play"},
    {"caster_kick", "it comes of the caster's own links and joints, where the world has one"},
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
    {"turn_scrub", "it comes of the contact of wheel and ground, and has no parameter in turn rate"},
    {"turn_speed_loss", "it comes of the contact of wheel and ground, and has no parameter in turn rate"},
    {"voltage_sag", "the plugin has no supply voltage"},
    {"wheel_eccentricity", "the plugin's wheels are round; move the axle in the wheel's own link"},
    {"wheel_scale_mismatch", "the plugin has one radius for both wheels"},
    {"yaw_bias", "the plugin adds no turn rate"},
}};

std::string element(const std::string& indent, const std::string& name, double value) {
  return indent + "<" + name + ">" + short_number(value) + "</" + name + ">\n";
}

// Of forward motion or of turning on the spot.
std::string limits(const std::string& quantity, const Figure& figure) {
  return xml_remark("  ", quantity, figure) + element("  ", "max_" + quantity, figure.value) +
         element("  ", "min_" + quantity, -figure.value);
}

std::string limits(const std::string& quantity, const Figure& figure, double separation_m) {
  return limits("linear_" + quantity, figure) +
         limits("angular_" + quantity, scaled(figure, 2.0 / separation_m));
}

std::string plugin(const DriveFigures& figures, const WheelGeometry& wheel) {
  const Figure separation_m = scaled(figures.separation_multiplier, figures.wheel_separation_m);
  const Figure left_m = scaled(figures.left_radius_multiplier, wheel.radius_m);
  const Figure right_m = scaled(figures.right_radius_multiplier, wheel.radius_m);
  std::string text =
      "<plugin filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\">\n"
      "  <left_joint>left_wheel_joint</left_joint>\n  <right_joint>right_wheel_joint</right_joint>\n" +
      xml_remark("  ", "given " + short_number(figures.wheel_separation_m) + " m", separation_m) +
      element("  ", "wheel_separation", separation_m.value) +
      xml_remark("  ", "the mean; left " + value_of(left_m) + " m", left_m) +
      xml_remark("  ", "right " + value_of(right_m) + " m", right_m) +
      element("  ", "wheel_radius", 0.5 * (left_m.value + right_m.value));
  if (figures.largest_speed_m_s) text += limits("velocity", *figures.largest_speed_m_s, separation_m.value);
  if (figures.largest_change_m_s2)
    text += limits("acceleration", *figures.largest_change_m_s2, separation_m.value);
  return text + "</plugin>\n";
}

std::string joint(const std::string& side, double lag_s, const DriveFigures& figures,
                  const WheelGeometry& wheel) {
  const auto torque = wheel_torque(figures, lag_s, wheel);
  if (!torque) return "";
  std::string text = "<!-- Into <axis> of " + side +
                     "_wheel_joint, for a joint that is driven by torque: lag " +
                     config::fixed_number(lag_s, 3) + " s. -->\n<dynamics>\n" +
                     element("  ", "damping", torque->damping_n_m_s);
  if (figures.friction_loss_m_s) {
    text += xml_remark("  ", "of a speed loss of " + value_of(*figures.friction_loss_m_s) + " m/s",
                       scaled(*figures.friction_loss_m_s, torque->damping_n_m_s / wheel.radius_m)) +
            element("  ", "friction", torque->friction_n_m);
  }
  return text + "</dynamics>\n";
}

}  // namespace

ModelText to_sdf(const RobotModel& model, const WheelGeometry& wheel) {
  const DriveFigures figures = drive_figures(model);
  const std::string left = joint("left", figures.lag_s.left, figures, wheel);
  const std::string right = joint("right", figures.lag_s.right, figures, wheel);
  const bool torques = !left.empty() && !right.empty();
  std::vector<Unsaid> unsaid =
      torques ? unsaid_of(model, sdf_put_with_torque, sdf_reasons) : unsaid_of(model, sdf_put, sdf_reasons);
  const std::string notes =
      "Of the linear part the plugin has no place for its gain (left " + short_number(figures.gain.left) +
      ", right " + short_number(figures.gain.right) + ")" +
      (torques ? "." : " and its delay; dynamics of the joints take the inertia of a wheel.");
  return {xml_head("wheelwright_sdf", model, notes, unsaid) + plugin(figures, wheel) + left + right,
          std::move(unsaid)};
}

}  // namespace wheelwright::tools

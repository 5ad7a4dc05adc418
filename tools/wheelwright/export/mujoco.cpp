#include "tools/wheelwright/export/mujoco.hpp"

#include <array>
#include <stdexcept>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::array<std::string_view, 5> mujoco_put{"saturation", "coulomb_friction", "wheel_scale_mismatch",
                                                     "distance_scale", "effective_track"};

constexpr std::array<UnsaidReason, 21> mujoco_reasons{{
    {"acceleration_slip",
     "slip comes of the contact of wheel and ground, which has no parameter in acceleration"},
    {"asymmetric_response", "an actuator is as quick both ways"},
    {"backlash", "it takes two joints with a gap between them, in the body's own tree"},
    {"caster_kick", "it comes of the caster's own body and joints, where the model has one"},
    {"command_quantization", "controls are continuous"},
    {"dead_zone", "an actuator passes every control"},
    {"direction_gain", "an actuator has one gain both ways"},
    {"encoder_dropout", "sensors have no faults"},
    {"floor_slope", "it is a property of the world: tilt gravity or the ground"},
    {"gain_curve", "an actuator's gain is affine"},
    {"gain_drift", "parameters do not change with time"},
    {"lever_arm", "it belongs into the place of the sensor's site"},
    {"rate_limit", "an actuator's change is not limited; a filter of the controls would have to do it"},
    {"stiction", "frictionloss is as large at rest as in motion"},
    {"surface_patch", "it is a property of the world: give that place a geometry with friction of its own"},
    {"transport_delay", "an actuator acts on a control at once"},
    {"turn_scrub", "it comes of the contact of wheel and ground, and has no parameter in turn rate"},
    {"turn_speed_loss", "it comes of the contact of wheel and ground, and has no parameter in turn rate"},
    {"voltage_sag", "an actuator has no supply voltage"},
    {"wheel_eccentricity", "move the joint in the wheel's own body; there is no parameter for it"},
    {"yaw_bias", "there is no disturbance on the body"},
}};

struct DrivenWheel {
  std::string name;
  double gain;
  double lag_s;
};

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

std::string joint(const DrivenWheel& side, const DriveFigures& figures, const WheelTorque& torque,
                  double radius_m) {
  std::string text;
  if (figures.friction_loss_m_s) {
    text = xml_remark("", "frictionloss, of a speed loss of " + value_of(*figures.friction_loss_m_s) + " m/s",
                      scaled(*figures.friction_loss_m_s, torque.damping_n_m_s / radius_m));
  }
  return text + "<joint" + attribute("name", side.name + "_wheel_joint") + attribute("type", "hinge") +
         attribute("axis", "0 1 0") + attribute("damping", "0") +
         attribute("frictionloss", short_number(torque.friction_n_m)) + "/>\n";
}

// Torque = gain times control less damping times speed: settles at the model's gain, with its lag.
std::string actuator(const DrivenWheel& side, const DriveFigures& figures, const WheelTorque& torque,
                     double radius_m) {
  std::string text;
  std::string range = attribute("ctrllimited", "false");
  if (figures.largest_speed_m_s) {
    const Figure max_rad_s = scaled(*figures.largest_speed_m_s, 1.0 / (radius_m * side.gain));
    text = xml_remark(
        "  ", "ctrlrange, of a largest speed of " + value_of(*figures.largest_speed_m_s) + " m/s", max_rad_s);
    const std::string most = value_of(max_rad_s);
    range = attribute("ctrllimited", "true") + attribute("ctrlrange", "-" + most + " " + most);
  }
  return text + "  <!-- control in rad/s: the command in m/s divided by " + short_number(radius_m) +
         " m -->\n" + "  <general" + attribute("name", side.name + "_wheel") +
         attribute("joint", side.name + "_wheel_joint") + attribute("gear", "1") +
         attribute("gaintype", "fixed") +
         attribute("gainprm", short_number(torque.damping_n_m_s * side.gain)) +
         attribute("biastype", "affine") +
         attribute("biasprm", "0 0 " + short_number(-torque.damping_n_m_s)) + range + "/>\n";
}

std::string geometry(const DriveFigures& figures, const WheelGeometry& wheel) {
  const auto remark = [](const std::string& what, const Figure& figure) {
    return xml_remark("", what + " " + value_of(figure) + " m", figure);
  };
  return remark("between the wheels' bodies:",
                scaled(figures.separation_multiplier, figures.wheel_separation_m)) +
         remark("radius of the left wheel's geometry:",
                scaled(figures.left_radius_multiplier, wheel.radius_m)) +
         remark("radius of the right wheel's geometry:",
                scaled(figures.right_radius_multiplier, wheel.radius_m));
}

}  // namespace

ModelText to_mujoco(const RobotModel& model, const WheelGeometry& wheel) {
  const DriveFigures figures = drive_figures(model);
  const std::array sides{DrivenWheel{"left", figures.gain.left, figures.lag_s.left},
                         DrivenWheel{"right", figures.gain.right, figures.lag_s.right}};
  std::string joints;
  std::string actuators;
  for (const DrivenWheel& side : sides) {
    const auto torque = wheel_torque(figures, side.lag_s, wheel);
    if (!torque || !(side.gain > 0.0)) {
      throw std::invalid_argument("its " + side.name +
                                  " wheel has no lag or no gain, of which MuJoCo's actuator is made; "
                                  "fit the model to runs that show how the wheel starts and stops");
    }
    joints += joint(side, figures, *torque, wheel.radius_m);
    actuators += actuator(side, figures, *torque, wheel.radius_m);
  }
  std::vector<Unsaid> unsaid = unsaid_of(model, mujoco_put, mujoco_reasons);
  const std::string notes =
      "Of the linear part there is one lag per wheel (left " + config::fixed_number(figures.lag_s.left, 3) +
      " s, right " + config::fixed_number(figures.lag_s.right, 3) +
      " s) in the place of its response. The wheels' bodies have to add up to the inertia that was given.";
  return {xml_head("wheelwright_mujoco", model, notes, unsaid) + geometry(figures, wheel) + joints +
              "<actuator>\n" + actuators + "</actuator>\n",
          std::move(unsaid)};
}

}  // namespace wheelwright::tools

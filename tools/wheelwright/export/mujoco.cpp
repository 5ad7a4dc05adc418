#include "tools/wheelwright/export/mujoco.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/export/xml_text.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::array<std::string_view, 6> mujoco_put{"saturation",           "coulomb_friction",
                                                     "wheel_scale_mismatch", "distance_scale",
                                                     "effective_track",      "transport_delay"};
constexpr std::array<std::string_view, 5> mujoco_put_without_delay{
    "saturation", "coulomb_friction", "wheel_scale_mismatch", "distance_scale", "effective_track"};

constexpr std::array<UnsaidReason, 21> mujoco_reasons{{
    {"acceleration_slip",
     "slip results from the contact of wheel and ground, which has no parameter in acceleration"},
    {"asymmetric_response", "an actuator is as quick both ways"},
    {"backlash", "it takes two joints with a gap between them, in the body's own tree"},
    {"caster_kick", "it results from the caster's own body and joints, where the model has one"},
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
    {"transport_delay", "an actuator has a delay from MuJoCo 3.5 on, and the file is to be for an older one"},
    {"turn_scrub", "it results from the contact of wheel and ground, and has no parameter in turn rate"},
    {"turn_speed_loss", "it results from the contact of wheel and ground, and has no parameter in turn rate"},
    {"voltage_sag", "an actuator has no supply voltage"},
    {"wheel_eccentricity", "move the joint in the wheel's own body; there is no parameter for it"},
    {"yaw_bias", "there is no disturbance on the body"},
}};

// Less is no delay that a drive shows.
constexpr double min_delay_s = 1e-4;

struct DrivenWheel {
  std::string name;
  Part joint;
  Part actuator;
  Part wheel;
  Figure gain;
  FirstOrderResponse response;
  Figure radius_multiplier;
  WheelLimits limits;
  MujocoSide given;
};

std::array<DrivenWheel, 2> wheels_of(const DriveFigures& figures, const MujocoTarget& target) {
  return {
      DrivenWheel{"left", Part::left_joint, Part::left_actuator, Part::left_wheel, figures.left_gain,
                  figures.left_response, figures.left_radius_multiplier, figures.left_limits, target.left},
      DrivenWheel{"right", Part::right_joint, Part::right_actuator, Part::right_wheel, figures.right_gain,
                  figures.right_response, figures.right_radius_multiplier, figures.right_limits,
                  target.right}};
}

// Torque = gain times control less damping times speed: settles at the model's gain, with its lag.
void add_gain(std::vector<PlacedNumber>& numbers, const DrivenWheel& side, double damping,
              double control_per_rad_s) {
  const auto remark = [&](const Figure& figure) {
    return "settles at " + value_of(side.gain) + " of the command: " + remark_of(figure);
  };
  if (side.given.is_velocity) {
    // Its torque at the joint is gear kv (control - gear speed).
    Figure gear{control_per_rad_s / side.gain.value, {}, side.gain.from};
    if (side.gain.interval)
      gear.interval = {control_per_rad_s / side.gain.interval->upper,
                       control_per_rad_s / side.gain.interval->lower};
    numbers.push_back(one_of_list(measured(side.actuator, "gear", {gear}, "1", remark(gear)), 0));
    numbers.push_back(constant(side.actuator, "kv", damping / (gear.value * gear.value), "N m/(rad/s)"));
    return;
  }
  const double gear = side.given.gear;
  const Figure gain = scaled(side.gain, damping / (control_per_rad_s * gear));
  numbers.push_back(keyword(side.actuator, "gaintype", "fixed"));
  numbers.push_back(measured(side.actuator, "gainprm", {gain}, "N m/(rad/s)", remark(gain)));
  numbers.push_back(keyword(side.actuator, "biastype", "affine"));
  PlacedNumber bias = constant(side.actuator, "biasprm", 0.0, "N m/(rad/s)");
  bias.figures = {Figure{}, Figure{}, Figure{-damping / (gear * gear), {}, ""}};
  numbers.push_back(std::move(bias));
}

void add_range(std::vector<PlacedNumber>& numbers, const DrivenWheel& side, const Figure& largest_m_s,
               double control_per_m_s) {
  const Figure most = scaled(largest_m_s, control_per_m_s / side.gain.value);
  numbers.push_back(keyword(side.actuator, "ctrllimited", "true"));
  numbers.push_back(measured(side.actuator, "ctrlrange", {scaled(most, -1.0), most}, "control",
                             "of a largest speed of " + value_of(largest_m_s) + " m/s: " + remark_of(most)));
}

void add_delay(std::vector<PlacedNumber>& numbers, const DrivenWheel& side, const Figure& delay_s,
               double timestep_s) {
  if (delay_s.value < min_delay_s) {
    if (side.given.has_delay) numbers.push_back(constant(side.actuator, "delay", 0.0, "s"));
    return;
  }
  // MuJoCo draws a line between two controls of which the first should hold: half a timestep early.
  const Figure later_s = shifted(delay_s, 0.5 * timestep_s);
  const std::string beyond = delay_s.from.empty() ? "" : ", and beyond it: " + remark_of(later_s);
  numbers.push_back(measured(side.actuator, "delay", {later_s}, "s",
                             "needs MuJoCo 3.5; dead time " +
                                 config::fixed_number(side.response.dead_time_s, 4) +
                                 " s of the linear part and half a timestep" + beyond));
  // As many as the delay has steps; with fewer MuJoCo cuts it short. One more, and the interval's upper end.
  const double longest_s =
      later_s.interval ? std::max(later_s.interval->upper, later_s.value) : later_s.value;
  numbers.push_back(constant(side.actuator, "nsample", std::ceil(longest_s / timestep_s) + 1.0, "1"));
  numbers.push_back(keyword(side.actuator, "interp", "linear"));
}

void add_geometry(std::vector<PlacedNumber>& numbers, const DrivenWheel& side, const DriveFigures& figures,
                  const WheelGeometry& wheel) {
  const Figure half_m = scaled(figures.separation_multiplier, 0.5 * figures.wheel_separation_m);
  const Figure radius_m = scaled(side.radius_multiplier, wheel.radius_m);
  numbers.push_back(one_of_list(measured(side.wheel, "pos", {half_m}, "m",
                                         "half of the distance between the wheels: " + remark_of(half_m)),
                                1));
  numbers.push_back(
      one_of_list(measured(side.wheel, "size", {radius_m}, "m", "radius: " + remark_of(radius_m)), 0));
}

// As dry as the solver allows: by MuJoCo's defaults a wheel creeps where it should stand.
void add_dryness(std::vector<PlacedNumber>& numbers, Part joint, double timestep_s) {
  PlacedNumber reference = constant(joint, "solreffriction", 0.0, "s,1");
  reference.figures = {Figure{2.0 * timestep_s, {}, ""}, Figure{1.0, {}, ""}};
  PlacedNumber impedance = constant(joint, "solimpfriction", 0.0, "1");
  impedance.figures = {Figure{0.99, {}, ""}, Figure{0.999, {}, ""}, Figure{0.001, {}, ""}};
  numbers.push_back(std::move(reference));
  numbers.push_back(std::move(impedance));
}

void add_wheel(std::vector<PlacedNumber>& numbers, const DrivenWheel& side, const DriveFigures& figures,
               const WheelGeometry& wheel, const MujocoTarget& target) {
  const double lag_s = target.knows_delay ? side.response.lag_s : side.response.mean_delay_s;
  WheelGeometry rolling = wheel;
  if (rolling.inertia_kg_m2 && side.given.takes_radius)
    *rolling.inertia_kg_m2 *= std::pow(side.radius_multiplier.value, 2);
  const auto torque = wheel_torque(side.limits, lag_s, rolling);
  if (!torque || !(side.gain.value > 0.0)) {
    throw std::invalid_argument("its " + side.name +
                                " wheel has no lag or no gain, of which MuJoCo's actuator is made; "
                                "fit the model to runs that show how the wheel starts and stops");
  }
  add_geometry(numbers, side, figures, wheel);
  numbers.push_back(constant(side.joint, "damping", 0.0, "N m/(rad/s)"));
  numbers.push_back(
      measured(side.joint, "frictionloss", {torque->friction_n_m}, "N m", torque->friction_remark));
  if (torque->friction_n_m.value > 0.0) add_dryness(numbers, side.joint, target.timestep_s);
  add_gain(numbers, side, torque->damping_n_m_s, target.control_per_rad_s);
  if (side.limits.largest_speed_m_s)
    add_range(numbers, side, *side.limits.largest_speed_m_s, target.control_per_rad_s / wheel.radius_m);
  if (!target.knows_delay) return;
  const Figure beyond_s = figures.delay_s.value_or(Figure{});
  add_delay(numbers, side, shifted(beyond_s, side.response.dead_time_s), target.timestep_s);
}

std::string notes_on(const DriveFigures& figures, const MujocoTarget& target) {
  const auto of = [&](const FirstOrderResponse& response) {
    if (!target.knows_delay) return "lag " + config::fixed_number(response.mean_delay_s, 3) + " s";
    return "delay " + config::fixed_number(response.dead_time_s, 3) + " s and lag " +
           config::fixed_number(response.lag_s, 3) + " s";
  };
  return "Of the linear part there is a first-order response per wheel (left: " + of(figures.left_response) +
         "; right: " + of(figures.right_response) +
         "). The wheels' bodies have to add up to the inertia that was given.";
}

std::string geometry(const std::vector<PlacedNumber>& numbers, const DrivenWheel& side) {
  std::string text;
  for (const PlacedNumber& number : numbers_of(numbers, side.wheel)) {
    text += "<!-- " + side.name + " wheel, " + (number.key == "pos" ? "y of its body" : "size of its geom") +
            ": " + value_text(number) + " m, " + in_xml_comment(number.remark) + " -->\n";
  }
  return text;
}

std::string attributes(const std::vector<PlacedNumber>& numbers) {
  std::string text;
  for (const PlacedNumber& number : numbers) text += attribute_text(number.key, value_text(number));
  return text;
}

std::string joint(const std::vector<PlacedNumber>& numbers, const DrivenWheel& side) {
  const auto own = numbers_of(numbers, side.joint);
  return xml_remarks("", own) + "<joint" + attribute_text("name", side.name + "_wheel_joint") +
         attribute_text("type", "hinge") + attribute_text("axis", "0 1 0") + attributes(own) + "/>\n";
}

std::string actuator(const std::vector<PlacedNumber>& numbers, const DrivenWheel& side) {
  const auto own = numbers_of(numbers, side.actuator);
  return xml_remarks("  ", own) + "  <general" + attribute_text("name", side.name + "_wheel") +
         attribute_text("joint", side.name + "_wheel_joint") + attributes(own) + "/>\n";
}

}  // namespace

ModelNumbers mujoco_numbers(const RobotModel& model, const WheelGeometry& wheel, const MujocoTarget& target) {
  const DriveFigures figures = drive_figures(model);
  ModelNumbers result;
  for (const DrivenWheel& side : wheels_of(figures, target))
    add_wheel(result.numbers, side, figures, wheel, target);
  result.unsaid = target.knows_delay ? unsaid_of(model, mujoco_put, mujoco_reasons)
                                     : unsaid_of(model, mujoco_put_without_delay, mujoco_reasons);
  result.notes = notes_on(figures, target);
  return result;
}

ModelText to_mujoco(const RobotModel& model, const WheelGeometry& wheel, const MujocoTarget& target) {
  ModelNumbers all = mujoco_numbers(model, wheel, target);
  std::string places;
  std::string joints;
  std::string actuators;
  for (const DrivenWheel& side : wheels_of(drive_figures(model), target)) {
    places += geometry(all.numbers, side);
    joints += joint(all.numbers, side);
    actuators += actuator(all.numbers, side);
  }
  return {xml_head("wheelwright_mujoco", model, all) + places + joints +
              "<!-- Controls are in rad/s of the wheel: the command in m/s divided by " +
              nine_digits(wheel.radius_m) + " m. The timestep is " + nine_digits(target.timestep_s) +
              " s. -->\n<actuator>\n" + actuators + "</actuator>\n",
          std::move(all.unsaid)};
}

}  // namespace wheelwright::tools

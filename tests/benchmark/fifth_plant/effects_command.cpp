// Between the command and the voltage of the motor.
#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fifth {

namespace {

// Small: the firmware takes small commands for nothing; large: the bridge of the driver needs some volts to
// open.
std::string hide_dead_zone(const Setting& setting) {
  const double size_m_s = setting.drawn(0.03, 0.045, 0.06, 0.09);
  if (!setting.large) {
    setting.robot().firmware.threshold_m_s = size_m_s;
    return "the firmware takes commands below " + fixed(size_m_s, 3) + " m/s for zero";
  }
  set_both(setting.robot(), &DriverSpec::dead_v, volts(setting.robot(), size_m_s));
  return "the driver passes nothing below the voltage of " + fixed(size_m_s, 3) + " m/s";
}

// Small: the supply cannot give more; large: the firmware does not ask for more.
std::string hide_saturation(const Setting& setting) {
  const double fastest_m_s = setting.drawn(0.84, 0.9, 0.55, 0.7) * setting.experiment.style.top_m_s;
  if (setting.large) {
    setting.robot().firmware.fastest_m_s = fastest_m_s;
    return "the firmware limits wheels to " + fixed(fastest_m_s, 3) + " m/s";
  }
  set_both(setting.robot(), &DriverSpec::limit_v, volts(setting.robot(), fastest_m_s));
  return "the supply ends at the voltage of " + fixed(fastest_m_s, 3) + " m/s";
}

// Small: the firmware ramps; large: the driver limits the current.
std::string hide_rate_limit(const Setting& setting) {
  Robot& robot = setting.robot();
  const double rate_m_s2 = setting.drawn(0.6, 0.75, 0.28, 0.4);
  if (!setting.large) {
    robot.firmware.ramp_m_s2 = rate_m_s2 * setting.experiment.style.hurry_m_s2;
    return "the firmware ramps by " + fixed(robot.firmware.ramp_m_s2, 3) + " m/s^2";
  }
  const SideSpec& side = robot.sides[left_side];
  const double inertia_kg_m2 = 0.5 * robot.mass_kg * side.wheel.radius_m * side.wheel.radius_m +
                               side.motor.inertia_kg_m2 + side.wheel.inertia_kg_m2;
  const double limit_a = inertia_kg_m2 * rate_m_s2 / side.wheel.radius_m / side.motor.constant_v_s;
  set_both(robot, &DriverSpec::limit_a, limit_a);
  return "the driver limits its current to " + fixed(limit_a, 2) + " A, which is " + fixed(rate_m_s2, 2) +
         " m/s^2";
}

std::string hide_quantization(const Setting& setting) {
  setting.robot().firmware.step_m_s = setting.drawn(0.018, 0.026, 0.05, 0.08);
  return "the link to the driver has steps of " + fixed(setting.robot().firmware.step_m_s, 4) + " m/s";
}

std::string hide_delay(const Setting& setting) {
  const double more_s = setting.drawn(0.14, 0.2, 0.3, 0.45);
  setting.robot().firmware.delay_s += more_s;
  return "commands wait " + fixed(more_s, 3) + " s longer in a queue";
}

// Small: the driver gives less than its share at high duty; large: drag by the square of the speed.
std::string hide_gain_curve(const Setting& setting) {
  Robot& robot = setting.robot();
  const double share = setting.drawn(0.07, 0.1, 0.2, 0.3);
  if (!setting.large) {
    for (SideSpec& side : robot.sides) {
      side.driver.full_v = volts(robot, robot.top_m_s);
      side.driver.bend = share;
    }
    return "the driver loses " + fixed(100.0 * share, 1) + " % of its gain at the top speed";
  }
  const double top_rad_s = robot.top_m_s / robot.sides[left_side].wheel.radius_m;
  set_both(robot, &GearSpec::quadratic_n_m_s2,
           torque_n_m(robot, share * robot.top_m_s) / (top_rad_s * top_rad_s));
  return "drag by the square of the speed takes " + fixed(100.0 * share, 1) + " % at the top speed";
}

std::string hide_direction_gain(const Setting& setting) {
  const double share = 1.0 + setting.random.sign() * setting.drawn(0.035, 0.05, 0.09, 0.13);
  for (SideSpec& side : setting.robot().sides) side.motor.reverse_share = share;
  return "advanced brushes: in reverse the motor's constant is " + fixed(share, 3) + " of the forward one";
}

// Small: the firmware is gentle in slowing down; large: the driver cannot brake.
std::string hide_asymmetric_response(const Setting& setting) {
  Robot& robot = setting.robot();
  if (!setting.large) {
    robot.firmware.smoothing_down_s = robot.firmware.smoothing_s + setting.drawn(0.12, 0.16, 0.0, 0.0);
    return "wanted speed rises in " + fixed(robot.firmware.smoothing_s, 3) + " s and falls in " +
           fixed(robot.firmware.smoothing_down_s, 3) + " s";
  }
  const double coast_s = setting.random.uniform(0.35, 0.6);
  const SideSpec& first = robot.sides[left_side];
  const double inertia_kg_m2 = 0.5 * robot.mass_kg * first.wheel.radius_m * first.wheel.radius_m;
  set_both(robot, &GearSpec::viscous_n_m_s, inertia_kg_m2 / coast_s);
  for (SideSpec& side : robot.sides) side.driver.brakes = false;
  return "the driver cannot brake: the robot coasts, with a time constant of " + fixed(coast_s, 2) + " s";
}

}  // namespace

std::vector<Effect> command_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"dead_zone",
       {.programme = slow, .confusable = "stiction"},
       {.sensing = ticks_and_poses,
        .programme = teleoperation,
        .drive = Drive::soft,
        .confusable = "coulomb_friction stiction"},
       hide_dead_zone},
      {"saturation",
       {.programme = patrol, .drive = Drive::soft, .confusable = "gain_curve"},
       {.sensing = poses, .programme = teleoperation, .confusable = "gain_curve"},
       hide_saturation},
      {"rate_limit",
       {.programme = teleoperation},
       {.sensing = ticks_and_poses, .programme = errands, .drive = Drive::soft},
       hide_rate_limit},
      {"command_quantization", {.programme = laps}, {.programme = docking}, hide_quantization},
      {"transport_delay", {.programme = errands}, {.sensing = poses, .programme = teleoperation}, hide_delay},
      {"gain_curve",
       {.programme = corridor, .drive = Drive::soft},
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft},
       hide_gain_curve},
      {"direction_gain",
       {.programme = corridor, .drive = Drive::soft},
       {.sensing = poses, .programme = teleoperation, .drive = Drive::soft},
       hide_direction_gain},
      {"asymmetric_response",
       {.programme = errands},
       {.sensing = ticks_and_poses, .programme = errands, .drive = Drive::soft},
       hide_asymmetric_response},
  };
}

}  // namespace plants::fifth

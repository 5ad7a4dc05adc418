#include "tests/benchmark/third_plant/random_robot.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

namespace {

double rounded(double value, double step) {
  return step * std::round(value / step);
}

void set_body(RobotSpec& robot, Random& random) {
  robot.wheel_base_m = rounded(random.uniform(0.15, 0.45), 1.0e-4);
  robot.undercarriage.track_m = robot.wheel_base_m;
  const double wheel_radius_m = random.uniform(0.03, 0.06);
  robot.encoder.metres_per_tick = rounded(random.log_uniform(1.0e-4, 1.0e-3), 1.0e-8);
  robot.period_s = 0.001 * random.integer(15, 20);
  robot.fastest_m_s = random.uniform(0.25, 0.5);
  robot.fastest_turn_rad_s = std::min(random.uniform(1.5, 2.6), 1.7 * robot.fastest_m_s / robot.wheel_base_m);
  robot.undercarriage.fastest_turn_rad_s = robot.fastest_turn_rad_s;
  robot.rim_mass_kg = random.uniform(1.0, 3.0);
  for (GearSpec& gear : robot.gear) {
    gear.wheel_radius_m = wheel_radius_m;
    gear.rim_mass_kg = robot.rim_mass_kg;
  }
}

struct TimeConstants {
  double motor_s;  // without a closed loop
  double loop_s;
};

TimeConstants random_time_constants(bool closed_loop, Response response, Random& random) {
  if (closed_loop) {
    const double motor_s = random.uniform(0.1, 0.22);
    if (response == Response::quick) return {motor_s, random.uniform(0.03, 0.05)};
    return {motor_s, std::min(random.uniform(0.035, 0.1), 0.7 * motor_s)};
  }
  double motor_s = 0.0;
  switch (response) {
    case Response::any:
      motor_s = random.uniform(0.045, 0.16);
      break;
    case Response::middling:
      motor_s = random.uniform(0.07, 0.14);
      break;
    case Response::quick:
      motor_s = random.uniform(0.04, 0.06);
      break;
  }
  return {motor_s, motor_s};
}

void set_motor(RobotSpec& robot, double motor_s, Random& random) {
  constexpr double voltage_reserve = 2.2;
  robot.drive_stiffness_n_s_m = robot.rim_mass_kg / motor_s;
  const double drag = random.uniform(0.12, 0.3);  // relative to what the back-EMF brakes
  MotorSpec& motor = robot.motor;
  motor.drag_n_s_m = robot.drive_stiffness_n_s_m * drag / (1.0 + drag);
  motor.constant_n_a = robot.supply.nominal_v / (voltage_reserve * robot.fastest_m_s);
  motor.resistance_ohm = motor.constant_n_a * motor.constant_n_a * (1.0 + drag) / robot.drive_stiffness_n_s_m;
  motor.volts_per_m_s = motor.resistance_ohm * robot.drive_stiffness_n_s_m / motor.constant_n_a;
  motor.electrical_time_s = random.uniform(0.001, 0.003);
  motor.full_scale_m_s = robot.fastest_m_s;
}

void set_controller(RobotSpec& robot, bool closed_loop, const TimeConstants& times, Random& random) {
  ControllerSpec& controller = robot.controller;
  controller.closed_loop = closed_loop;
  controller.response_s = times.loop_s;
  if (!closed_loop) return;
  controller.proportional = times.motor_s / times.loop_s - 1.0;
  controller.integral_1_s = (1.0 + controller.proportional) / random.uniform(1.5, 4.0);
}

void set_imperfections_of_all(RobotSpec& robot, Random& random) {
  constexpr double gain_spread = 0.02;
  for (double& gain : robot.firmware.gain)
    gain = 1.0 + gain_spread * std::clamp(random.normal(1.0), -2.0, 2.0);
  robot.firmware.full_scale_m_s = robot.fastest_m_s;
  robot.firmware.delay_s = robot.period_s * random.uniform(0.8, 2.1);
  robot.noise.speed_m_s = random.uniform(0.0008, 0.0018);
  robot.noise.correlation_s = random.uniform(0.05, 0.12);
  robot.jitter_s = random.uniform(1.0e-4, 5.0e-4);
}

}  // namespace

RobotSpec random_robot(Loop loop, Response response, Random& random) {
  constexpr double closed_share = 0.6;
  const bool closed_loop = loop == Loop::closed || (loop == Loop::any && random.chance(closed_share));
  RobotSpec robot;
  set_body(robot, random);
  const TimeConstants times = random_time_constants(closed_loop, response, random);
  set_motor(robot, times.motor_s, random);
  set_controller(robot, closed_loop, times, random);
  set_imperfections_of_all(robot, random);
  return robot;
}

}  // namespace plants::third

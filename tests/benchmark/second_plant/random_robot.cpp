#include "tests/benchmark/second_plant/random_robot.hpp"

#include <numbers>

namespace plants::second {

namespace {

struct Loop {
  double time_constant_s;
  double proportional;  // relative to the back-EMF constant
  double integral_1_s;  // integral gain over the sum of back-EMF and proportional gain
};

Loop random_loop(Drive drive, Random& random) {
  if (drive == Drive::any) drive = random.chance(0.5) ? Drive::soft : Drive::stiff;
  if (drive == Drive::stiff)
    return {random.uniform(0.04, 0.10), random.uniform(0.3, 0.6), random.uniform(1.0, 3.0)};
  const double proportional = random.chance(0.5) ? 0.0 : random.uniform(0.1, 0.3);
  return {random.uniform(0.10, 0.28), proportional, 0.0};
}

void set_drive(RobotSpec& robot, const Loop& loop, Random& random) {
  constexpr double voltage_reserve = 4.0;
  MotorSpec& motor = robot.motor;
  motor.emf_v_s_m = motor.supply_v / (voltage_reserve * robot.fastest_m_s);
  motor.rotor_mass_kg = random.uniform(0.8, 1.8);
  const double moved_kg = motor.rotor_mass_kg + 0.5 * robot.body.mass_kg;
  const double wanted_stiffness_n_s_m = moved_kg / loop.time_constant_s;
  const double drag_n_s_m = random.uniform(0.05, 0.15) * wanted_stiffness_n_s_m;
  for (TyreSpec& tyre : robot.tyre) tyre.hub_drag_n_s_m = drag_n_s_m;

  ControllerSpec& controller = robot.controller;
  controller.proportional_v_s_m = loop.proportional * motor.emf_v_s_m;
  const double loop_v_s_m = motor.emf_v_s_m + controller.proportional_v_s_m;
  motor.resistance_ohm = motor.emf_v_s_m * loop_v_s_m / (wanted_stiffness_n_s_m - drag_n_s_m);
  motor.inductance_h = random.uniform(0.001, 0.003) * motor.resistance_ohm;
  controller.integral_v_m = loop.integral_1_s * loop_v_s_m;
  const double drag_v_s_m = drag_n_s_m * motor.resistance_ohm / motor.emf_v_s_m;
  controller.feedforward_v_s_m = random.uniform(0.95, 1.03) * (motor.emf_v_s_m + drag_v_s_m);
}

void set_body(RobotSpec& robot, Random& random) {
  BodySpec& body = robot.body;
  body.mass_kg = random.uniform(2.5, 4.5);
  body.nominal_track_m = 0.001 * random.integer(200, 400);
  body.true_track_m = body.nominal_track_m;
  const double gyration_m = random.uniform(0.40, 0.52) * body.nominal_track_m;
  body.yaw_inertia_kg_m2 = body.mass_kg * gyration_m * gyration_m;
}

void set_wheels(RobotSpec& robot, Random& random) {
  const double radius_m = random.uniform(0.030, 0.050);
  const double wheel_mass_kg = random.uniform(0.15, 0.3);
  for (TyreSpec& tyre : robot.tyre) {
    tyre.radius_m = radius_m;
    tyre.wheel_mass_kg = wheel_mass_kg;
    tyre.high_point_rad = random.uniform(0.0, 2.0 * std::numbers::pi);
  }
  robot.encoder.ticks_per_turn = random.integer(280, 700);
}

}  // namespace

RobotSpec random_robot(Drive drive, Random& random) {
  RobotSpec robot;
  robot.period_s = 0.001 * random.integer(15, 20);
  robot.fastest_m_s = 0.01 * random.integer(28, 45);
  robot.firmware.delay_s = random.uniform(0.010, 0.060);
  set_body(robot, random);
  set_wheels(robot, random);
  set_drive(robot, random_loop(drive, random), random);
  robot.battery.full_v = random.uniform(15.2, 16.5);
  return robot;
}

}  // namespace plants::second

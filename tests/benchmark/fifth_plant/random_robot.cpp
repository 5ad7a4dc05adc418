#include "tests/benchmark/fifth_plant/random_robot.hpp"

#include <array>

namespace plants::fifth {

namespace {

template <std::size_t Size>
double one_of(const std::array<double, Size>& values, Random& random) {
  return values[static_cast<std::size_t>(random.integer(0, static_cast<int>(Size) - 1))];
}

double inertia_kg_m2(const Robot& robot, const SideSpec& side) {
  return 0.5 * robot.mass_kg * side.wheel.radius_m * side.wheel.radius_m + side.motor.inertia_kg_m2 +
         side.wheel.inertia_kg_m2;
}

// Torque that the drive answers a speed with that is off by one.
double yield_n_m_s(const SideSpec& side) {
  const MotorSpec& motor = side.motor;
  if (side.loop.integral) return motor.constant_v_s * side.loop.proportional;
  return motor.constant_v_s * (motor.constant_v_s + side.loop.proportional) / motor.resistance_ohm +
         side.gear.viscous_n_m_s;
}

void wind_motor(const Robot& robot, SideSpec& side, bool soft, Random& random) {
  constexpr double spare = 0.75;  // of the voltage at the top speed
  MotorSpec& motor = side.motor;
  motor.constant_v_s = spare * side.driver.full_v * side.wheel.radius_m / robot.top_m_s;
  motor.inertia_kg_m2 = random.uniform(0.008, 0.018);
  const double inertia = inertia_kg_m2(robot, side);
  side.loop.period_s = random.chance(0.5) ? 0.002 : 0.005;
  if (soft) {
    const double yield = inertia / random.uniform(0.06, 0.13);
    side.gear.viscous_n_m_s = random.uniform(0.02, 0.05) * yield;
    side.loop.proportional = random.uniform(0.0, 0.4) * motor.constant_v_s;
    motor.resistance_ohm = motor.constant_v_s * (motor.constant_v_s + side.loop.proportional) /
                           (yield - side.gear.viscous_n_m_s);
  } else {
    motor.resistance_ohm = random.uniform(0.6, 1.2);
    side.gear.viscous_n_m_s = random.uniform(0.02, 0.08);
    const double bandwidth_rad_s = random.uniform(14.0, 26.0);
    side.loop.integral = true;
    side.loop.proportional = inertia * bandwidth_rad_s / motor.constant_v_s;
    side.loop.integral_per_s = random.uniform(0.12, 0.25) * bandwidth_rad_s;
  }
  motor.inductance_h = random.uniform(0.001, 0.002) * motor.resistance_ohm;
}

}  // namespace

Robot random_robot(Drive drive, Random& random) {
  Robot robot;
  robot.mass_kg = random.uniform(18.0, 42.0);
  robot.wheel_base_m = random.uniform(0.32, 0.52);
  robot.said_wheel_base_m = robot.wheel_base_m;
  robot.yaw_inertia_kg_m2 =
      robot.mass_kg * robot.wheel_base_m * robot.wheel_base_m * random.uniform(0.2, 0.3);
  robot.top_m_s = random.uniform(0.45, 0.85);
  robot.period_s = one_of(std::array{0.01, 0.02, 0.02, 0.025, 0.03, 0.04, 0.05}, random);
  robot.jitter_s = random.chance(0.5) ? random.uniform(0.0002, 0.0010) : 0.0;
  robot.stamp_noise_s = random.chance(0.5) ? random.uniform(0.00002, 0.0001) : 0.0;
  robot.firmware.delay_s = random.uniform(0.01, 0.05);
  robot.firmware.smoothing_s = random.uniform(0.02, 0.06);
  robot.firmware.smoothing_down_s = robot.firmware.smoothing_s;
  const bool soft = drive == Drive::any ? random.chance(0.5) : drive == Drive::soft;
  SideSpec side;
  side.wheel.radius_m = random.uniform(0.06, 0.085);
  side.wheel.said_radius_m = side.wheel.radius_m;
  wind_motor(robot, side, soft, random);
  const double shaken_m_s = random.uniform(0.0012, 0.0026);
  side.motor.disturbance_n_m = yield_n_m_s(side) * shaken_m_s / side.wheel.radius_m;
  side.motor.disturbance_memory_s = random.uniform(0.05, 0.25);
  robot.sides = {side, side};
  robot.sides[right_side].motor.inertia_kg_m2 *= random.uniform(0.95, 1.05);
  robot.floor.roughness = random.uniform(0.0010, 0.0024);
  robot.floor.roughness_memory_s = random.uniform(0.1, 0.3);
  robot.floor.slip_stiffness_n = random.uniform(350.0, 550.0) * robot.mass_kg;
  robot.floor.grip_n = 3.5 * robot.mass_kg;
  robot.encoder.metres_per_tick = random.log_uniform(0.0001, 0.0006);
  robot.battery.noise_v = random.uniform(0.005, 0.03);
  robot.tracker.latency_s = random.chance(0.6) ? random.uniform(0.008, 0.05) : 0.0;
  if (random.chance(0.5)) {
    robot.tracker.smoothing_s = random.uniform(0.02, 0.06);
    robot.tracker.slow_noise_m = random.uniform(0.0003, 0.001);
  }
  return robot;
}

double torque_n_m(const Robot& robot, double loss_m_s) {
  const SideSpec& side = robot.sides[left_side];
  return yield_n_m_s(side) * loss_m_s / side.wheel.radius_m;
}

double force_n(const Robot& robot, double loss_m_s) {
  return 2.0 * torque_n_m(robot, loss_m_s) / robot.sides[left_side].wheel.radius_m;
}

double moment_n_m(const Robot& robot, double loss_rad_s) {
  const double half_base_m = 0.5 * robot.wheel_base_m;
  return half_base_m * force_n(robot, half_base_m * loss_rad_s);
}

double volts(const Robot& robot, double speed_m_s) {
  const SideSpec& side = robot.sides[left_side];
  return side.motor.constant_v_s * speed_m_s / side.wheel.radius_m;
}

void set_both(Robot& robot, double GearSpec::*quantity, double value) {
  for (SideSpec& side : robot.sides) side.gear.*quantity = value;
}

void set_both(Robot& robot, double DriverSpec::*quantity, double value) {
  for (SideSpec& side : robot.sides) side.driver.*quantity = value;
}

}  // namespace plants::fifth

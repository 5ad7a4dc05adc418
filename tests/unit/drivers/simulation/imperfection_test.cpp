// Each imperfection shows where it should, and is absent at 0.
#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;

namespace {

// Speed after `settling` at a fixed duty.
double speed_in_pwm(const SimulationConfig& config, std::chrono::nanoseconds settling = 3s) {
  Host host(config);
  host.start();
  host.drive_pwm(120, 120);
  host.robot.advance(settling);
  return host.robot.truth().v_m_s;
}

double heading_after_reversal(const SimulationConfig& config) {
  Host host(config);
  host.start();
  host.drive(150, 150);
  host.robot.advance(2s);
  host.drive(-150, -150);
  host.robot.advance(2s);
  return host.robot.truth().pose.theta_rad;
}

}  // namespace

TEST_CASE("Without speed control the speed follows the battery's charge") {
  SimulationConfig full;
  full.battery.full_voltage_v = 16.0;
  full.battery.empty_voltage_v = 12.0;
  full.battery.charge = 1.0;
  SimulationConfig empty = full;
  empty.battery.charge = 0.0;
  CHECK_THAT(speed_in_pwm(empty) / speed_in_pwm(full), WithinRel(12.0 / 16.0, 0.001));
}

TEST_CASE("An internal resistance lowers the voltage by current times resistance") {
  SimulationConfig config;
  config.battery.internal_resistance_ohm = 0.5;
  config.battery.idle_current_a = 1.0;
  Host host(config);
  host.robot.advance(1s);
  CHECK_THAT(host.robot.truth().battery_voltage_v, WithinAbs(16.2 - 0.5, 1e-6));
}

TEST_CASE("A battery is empty after its capacity has been drawn") {
  SimulationConfig config;
  config.battery = {.full_voltage_v = 16.0, .empty_voltage_v = 12.0, .capacity_mah = 100.0, .charge = 1.0};
  config.battery.idle_current_a = 1.0;
  Host host(config);
  host.robot.advance(180s);  // half of 0.1 Ah at 1 A
  CHECK_THAT(host.robot.truth().battery_voltage_v, WithinAbs(14.0, 0.01));
}

TEST_CASE("Motors that warm up change speed with the configured time constant") {
  SimulationConfig config;
  for (WheelConfig* wheel : {&config.left, &config.right}) {
    wheel->friction.viscous_nm_s_per_rad = 0.04;
    wheel->motor.warm_up_time_s = 60.0;
  }
  const double cold = speed_in_pwm(config);
  CHECK_THAT(speed_in_pwm(config, 300s), WithinRel(cold, 1e-9));
  config.left.motor.friction_change_when_warm = config.right.motor.friction_change_when_warm = -0.5;
  const double warm = speed_in_pwm(config, 600s);
  CHECK(warm > 1.1 * cold);
  const double after_one_constant = speed_in_pwm(config, 60s);
  CHECK_THAT((after_one_constant - cold) / (warm - cold), WithinAbs(1.0 - std::exp(-1.0), 0.06));
}

TEST_CASE("An eccentric wheel makes the speed ripple once per turn, by its fraction") {
  auto config = shipped_robot("perfect.yaml");
  config.left.eccentricity = config.right.eccentricity = 0.02;
  Host host(config);
  host.start();
  host.drive(226, 226);  // one turn a second
  host.robot.advance(3s);
  double least = 1.0;
  double most = 0.0;
  for (int i = 0; i < 1000; ++i) {
    host.robot.advance(1ms);
    least = std::min(least, host.robot.truth().v_m_s);
    most = std::max(most, host.robot.truth().v_m_s);
  }
  CHECK_THAT((most - least) / (most + least), WithinAbs(0.02, 0.002));
}

TEST_CASE("A caster kicks the nose aside on reversal, and does not if its swivel is free") {
  SimulationConfig config;
  config.room.floor.creep_per_n = 0.002;
  CHECK_THAT(heading_after_reversal(config), WithinAbs(0.0, 1e-9));
  config.chassis.caster.swivel_torque_nm = 0.03;
  CHECK(std::abs(heading_after_reversal(config)) > 1e-4);
}

TEST_CASE("A wheel drives more slowly where the floor is different") {
  SimulationConfig config;
  config.room.floor.creep_per_n = 0.002;
  Surface carpet = config.room.floor;
  carpet.rolling_drag = 0.1;
  config.room.patches = {{{.x_m = 1.0, .size_x_m = 0.6, .size_y_m = 2.0}, carpet}};
  Host host(config);
  host.start();
  host.drive_pwm(80, 80);
  host.robot.advance(2s);
  double on_carpet = 1.0;
  double before = host.robot.truth().v_m_s;
  REQUIRE(host.robot.truth().pose.x_m < 0.6);
  while (host.robot.truth().pose.x_m < 1.6) {
    host.robot.advance(10ms);
    if (std::abs(host.robot.truth().pose.x_m - 1.0) < 0.3) {
      on_carpet = std::min(on_carpet, host.robot.truth().v_m_s);
    }
  }
  CHECK(on_carpet < 0.95 * before);
  host.robot.advance(1s);
  CHECK_THAT(host.robot.truth().v_m_s, WithinRel(before, 0.01));
}

TEST_CASE("Wheels of different size pull the robot into a circle of the radius that geometry says") {
  auto config = shipped_robot("perfect.yaml");
  config.left.diameter_m = 0.0724;
  config.right.diameter_m = 0.0716;
  Host host(config);
  host.start();
  host.drive(150, 150);
  host.robot.advance(10s);
  const GroundTruth truth = host.robot.truth();
  const double per_metre_rad = (0.0716 - 0.0724) / 0.072 / config.chassis.wheel_base_m;
  const double way_m = 0.5 * (static_cast<double>(truth.counts_left) * truth.metres_per_tick_left +
                              static_cast<double>(truth.counts_right) * truth.metres_per_tick_right);
  CHECK_THAT(truth.pose.theta_rad, WithinRel(per_metre_rad * way_m, 0.02));
}

#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;

namespace {

std::vector<GroundTruth> record(Host& host, int samples, std::chrono::nanoseconds period) {
  std::vector<GroundTruth> truths;
  for (int i = 0; i < samples; ++i) {
    host.robot.advance(period);
    truths.push_back(host.robot.truth());
  }
  return truths;
}

// The clocks of physics and firmware in step, so that samples 10 ms apart are exactly that.
SimulationConfig evenly_stepped_robot() {
  SimulationConfig config;
  config.firmware.tick_s = config.firmware.sensor_update_period_s = 0.01;
  return config;
}

std::vector<GroundTruth> step_response(int left_mm_s, int right_mm_s) {
  Host host(shipped_robot("perfect.yaml"));
  host.start();
  host.drive(left_mm_s, right_mm_s);
  return record(host, 100, 10ms);
}

}  // namespace

TEST_CASE("On the perfect robot the response to two commands is the sum of their responses") {
  const auto left = step_response(120, 0);
  const auto right = step_response(0, -90);
  const auto both = step_response(120, -90);
  for (std::size_t i = 0; i < both.size(); ++i) {
    CHECK_THAT(both[i].speed_left_m_s, WithinAbs(left[i].speed_left_m_s + right[i].speed_left_m_s, 0.0005));
    CHECK_THAT(both[i].speed_right_m_s,
               WithinAbs(left[i].speed_right_m_s + right[i].speed_right_m_s, 0.0005));
  }
}

TEST_CASE("On the perfect robot twice the command is twice the speed, forward and backward") {
  const auto once = step_response(100, 100);
  const auto twice = step_response(200, 200);
  const auto back = step_response(-100, -100);
  for (std::size_t i = 0; i < once.size(); ++i) {
    CHECK_THAT(twice[i].v_m_s, WithinAbs(2.0 * once[i].v_m_s, 0.001));
    CHECK_THAT(back[i].v_m_s, WithinAbs(-once[i].v_m_s, 0.001));
  }
}

TEST_CASE("The distance of a straight drive is counts times metres per tick") {
  Host host(shipped_robot("perfect.yaml"));
  host.start();
  host.drive(150, 150);
  host.robot.advance(6s);
  const GroundTruth truth = host.robot.truth();
  CHECK(truth.pose.x_m > 0.8);
  CHECK_THAT(static_cast<double>(truth.counts_left) * truth.metres_per_tick_left,
             WithinAbs(truth.pose.x_m, truth.metres_per_tick_left));
  CHECK_THAT(truth.pose.y_m, WithinAbs(0.0, 1e-9));
}

TEST_CASE("A turn in place is the difference of the wheels' ways over the true wheel base") {
  Host host(shipped_robot("perfect.yaml"));
  host.start();
  host.drive(-100, 100);
  host.robot.advance(8s);
  const GroundTruth truth = host.robot.truth();
  const double ways_m =
      static_cast<double>(truth.counts_right - truth.counts_left) * truth.metres_per_tick_left;
  CHECK(truth.pose.theta_rad > 6.0);
  CHECK_THAT(truth.pose.theta_rad,
             WithinAbs(ways_m / truth.wheel_base_m, 2.0 * truth.metres_per_tick_left / truth.wheel_base_m));
}

TEST_CASE("Coasting against Coulomb friction alone is a straight line of the slope that physics says") {
  SimulationConfig config = evenly_stepped_robot();
  for (WheelConfig* wheel : {&config.left, &config.right}) {
    wheel->motor.bridge_can_brake = false;
    wheel->friction.viscous_nm_s_per_rad = 0.0;
    wheel->friction.coulomb_nm = 0.1;
  }
  Host host(config);
  host.start();
  host.drive_pwm(200, 200);
  host.robot.advance(2s);
  host.drive_pwm(0, 0);
  host.robot.advance(50ms);
  const auto truths = record(host, 40, 10ms);
  const double radius_m = 0.5 * config.left.diameter_m;
  const double inertia_kg_m2 = config.left.inertia_kg_m2 + config.left.motor.inertia_kg_m2;
  const double moved_kg = config.chassis.mass_kg + 2.0 * inertia_kg_m2 / (radius_m * radius_m);
  const double slope_m_s2 = 2.0 * config.left.friction.coulomb_nm / radius_m / moved_kg;
  for (std::size_t i = 1; i < truths.size(); ++i) {
    REQUIRE(truths[i].v_m_s > 0.05);
    CHECK_THAT((truths[i - 1].v_m_s - truths[i].v_m_s) / 0.01, WithinRel(slope_m_s2, 0.01));
  }
}

TEST_CASE("Coasting against viscous friction alone is an exponential") {
  SimulationConfig config = evenly_stepped_robot();
  config.left.motor.bridge_can_brake = config.right.motor.bridge_can_brake = false;
  config.left.friction.viscous_nm_s_per_rad = config.right.friction.viscous_nm_s_per_rad = 0.02;
  Host host(config);
  host.start();
  host.drive_pwm(200, 200);
  host.robot.advance(2s);
  host.drive_pwm(0, 0);
  host.robot.advance(50ms);
  const auto truths = record(host, 50, 10ms);
  const double ratio = truths[1].v_m_s / truths[0].v_m_s;
  CHECK(ratio < 0.99);
  for (std::size_t i = 1; i < truths.size(); ++i) {
    CHECK_THAT(truths[i].v_m_s / truths[i - 1].v_m_s, WithinRel(ratio, 1e-4));
  }
}

TEST_CASE("A wheel with stiction does not creep below its break-away torque, and moves above it") {
  SimulationConfig config;
  for (WheelConfig* wheel : {&config.left, &config.right}) {
    wheel->friction.coulomb_nm = 0.08;
    wheel->friction.stiction_nm = 0.12;
  }
  // 0.12 Nm needs 0.12 / 0.8 A * 8 ohm = 1.2 V of 16.2 V, that is 18.9 of 255.
  Host host(config);
  host.start();
  host.drive_pwm(17, 17);
  host.robot.advance(5s);
  CHECK(std::abs(host.robot.truth().pose.x_m) < 0.0005);
  host.drive_pwm(24, 24);
  host.robot.advance(2s);
  CHECK(host.robot.truth().v_m_s > 0.01);
}

TEST_CASE("Without a motor the motion never gains energy, whatever is worn") {
  auto config = shipped_robot("old_motors.yaml");
  config.room = {};
  config.room.floor.grip = 0.5;
  config.room.floor.creep_per_n = 0.003;
  constexpr double in_bristles_j = 4e-4;  // 1 mrad of stiction on two wheels, which spring back at the end
  for (const auto& [left, right] : {std::pair{200, 200}, std::pair{-180, 220}, std::pair{-200, -120}}) {
    Host host(config);
    host.start();
    host.drive_pwm(left, right);
    host.robot.advance(2s);
    host.drive_pwm(0, 0);
    host.robot.advance(50ms);
    double lowest_j = host.robot.truth().kinetic_energy_j;
    for (const GroundTruth& truth : record(host, 2000, 1ms)) {
      CHECK(truth.kinetic_energy_j <= lowest_j + in_bristles_j);
      lowest_j = std::min(lowest_j, truth.kinetic_energy_j);
    }
    CHECK(host.robot.truth().wheels_at_rest);
  }
}

TEST_CASE("On ice the wheels spin and the body is left behind") {
  SimulationConfig config;
  config.room.floor.grip = 0.02;
  Host host(config);
  host.start();
  host.drive(400, 400);
  host.robot.advance(1s);
  const GroundTruth truth = host.robot.truth();
  const double rolled_m = static_cast<double>(truth.counts_left) * truth.metres_per_tick_left;
  CHECK(truth.v_m_s <= 0.02 * 0.8 * 9.81 * 1.0 + 1e-9);
  CHECK(rolled_m > 2.0 * truth.pose.x_m);
}

TEST_CASE("On carpet the robot turns less for the same counts") {
  const auto turn = [](const std::string& room) {
    auto config = shipped_robot("default.yaml");
    config.room =
        wheelwright::config::load_room(std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/robots/rooms/" + room);
    Host host(config);
    host.start();
    host.drive(-100, 100);
    host.robot.advance(8s);
    const GroundTruth truth = host.robot.truth();
    const auto& encoder = config.encoder;
    return truth.pose.theta_rad / static_cast<double>((truth.counts_right - encoder.start_count_right) -
                                                      (truth.counts_left - encoder.start_count_left));
  };
  const double ratio = turn("carpet.yaml") / turn("box.yaml");
  CHECK(ratio < 0.99);
  CHECK(ratio > 0.8);
}

TEST_CASE("A wall stops the robot, presses the bumper and lets the wheels slip") {
  SimulationConfig config;
  config.room.walls = {{0.5, -2.0, 0.5, 2.0}};
  config.room.floor.grip = 0.5;
  Host host(config);
  host.start();
  host.drive(200, 200);
  host.robot.advance(5s);
  const GroundTruth truth = host.robot.truth();
  CHECK_THAT(truth.pose.x_m, WithinAbs(0.5 - config.chassis.bumper_radius_m, 0.002));
  CHECK(host.packet(7) == 3);
  CHECK(static_cast<double>(truth.counts_left) * truth.metres_per_tick_left > 0.6);
}

TEST_CASE("A stalled wheel makes the robot circle around it") {
  Host host{SimulationConfig{}};
  host.start();
  host.robot.inject({.kind = Fault::Kind::stall_wheel, .side = Side::left});
  host.drive(100, 100);
  host.robot.advance(2s);
  CHECK_THAT(host.robot.truth().speed_left_m_s, WithinAbs(0.0, 1e-6));
  CHECK(host.robot.truth().speed_right_m_s > 0.08);
  CHECK(host.packet(54) > 500);
}

TEST_CASE("A wheel in the air turns and moves nothing") {
  Host host{SimulationConfig{}};
  host.start(132);
  host.robot.inject({.kind = Fault::Kind::lift_wheel, .side = Side::left});
  host.drive(200, 0);
  host.robot.advance(2s);
  CHECK(host.robot.truth().counts_left > 500);
  CHECK_THAT(host.robot.truth().pose.theta_rad, WithinAbs(0.0, 0.01));
}

TEST_CASE("The gear's play swallows the first motion after a reversal") {
  SimulationConfig config;
  config.left.backlash_rad = config.right.backlash_rad = 0.1;
  config.room.floor.rolling_drag = 0.05;  // keeps the teeth together
  Host host(config);
  host.start();
  host.drive(100, 100);
  host.robot.advance(2s);
  host.drive(-100, -100);
  host.robot.advance(4s);
  const GroundTruth truth = host.robot.truth();
  const double counted_m = static_cast<double>(truth.counts_left) * truth.metres_per_tick_left;
  // First half the play forward, then the whole play backward.
  const double lost_m = (0.05 - 0.1) * 0.5 * config.left.diameter_m;
  CHECK_THAT(counted_m - truth.pose.x_m, WithinAbs(lost_m, 0.001));
}

TEST_CASE("On a slope a robot without speed control drifts downhill") {
  SimulationConfig config;
  config.room.floor.slope_x = 0.05;
  Host host(config);
  host.robot.advance(2s);
  CHECK(host.robot.truth().v_m_s < -0.01);
}

TEST_CASE("The same seed gives the same bytes however time is cut, and another seed others") {
  auto config = shipped_robot("bad_cable.yaml");
  const auto bytes_of = [&](std::chrono::nanoseconds slice) {
    Host host(config);
    host.start();
    host.send({148, 3, 22, 43, 48});
    host.drive(-80, 80);
    Bytes all;
    for (std::chrono::nanoseconds t = 0ns; t < 8s; t += slice) {
      const Bytes more = host.ask({}, slice);
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  };
  const Bytes first = bytes_of(8s);
  CHECK(first.size() > 5000);
  CHECK(first == bytes_of(1ms));
  CHECK(first == bytes_of(160us));
  config.seed += 1;
  CHECK(first != bytes_of(1ms));
}

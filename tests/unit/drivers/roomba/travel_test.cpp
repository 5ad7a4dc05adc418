// True travel of a wheel out of counts that know only the command's sign: link and counter against the
// simulated robot.
#include <cmath>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/linked_robot.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright;
using namespace wheelwright::roomba;
using simulation::EncoderSign;

namespace {

struct Robot {
  std::string file;
  EncoderSign sign;
};

const std::vector<Robot>& robots() {
  static const std::vector<Robot> all{{"default.yaml", EncoderSign::command},
                                      {"default.yaml", EncoderSign::true_direction},
                                      {"default.yaml", EncoderSign::motor_drive},
                                      {"create2_proportional.yaml", EncoderSign::motor_drive}};
  return all;
}

LinkedRobot started(const Robot& robot, int phase) {
  auto config = simulation::shipped_robot(robot.file);
  config.room = {};  // nothing to hit, and no slip: what the wheel turns is what the body moves
  config.encoder.sign = robot.sign;
  config.encoder.start_count_left = 65530;
  LinkedRobot linked(LinkConfig{}, config);
  linked.robot.advance(std::chrono::microseconds(1300 * phase));
  linked.start();
  REQUIRE(linked.link.armed());
  return linked;
}

// The larger error of the two wheels, in ticks.
double error_ticks(const LinkedRobot& linked, const SensorFrame& frame) {
  return std::max(std::abs(static_cast<double>(frame.ticks.left) - linked.true_ticks.left),
                  std::abs(static_cast<double>(frame.ticks.right) - linked.true_ticks.right));
}

template <typename Manoeuvre>
double worst_error_ticks(const Robot& robot, Manoeuvre manoeuvre) {
  double worst = 0.0;
  for (int phase = 0; phase < 6; ++phase) {
    LinkedRobot linked = started(robot, phase);
    manoeuvre(linked);
    worst = std::max(worst, error_ticks(linked, linked.drive_for(60, 0.0, 0.0)));
  }
  return worst;
}

std::string name(const Robot& robot) {
  return robot.file + ", sign rule " + std::to_string(static_cast<int>(robot.sign));
}

constexpr double speeds_m_s[]{0.04, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3};

double ticks_in_a_sample(double speed_m_s) {
  return speed_m_s * 0.018 / 0.000445;
}

// A minute of it; the larger error of the wheels over what a wheel travelled.
double share_of_random_travel_in_error(const Robot& robot) {
  open_interface::Random random(41);
  LinkedRobot linked = started(robot, 0);
  double travelled_ticks = 0.0;
  for (int ticks = 0; ticks < 3333;) {
    const int duration = open_interface::between(random, 15, 120);
    const double left_m_s = 0.001 * open_interface::between(random, -300, 300);
    const double right_m_s = 0.001 * open_interface::between(random, -300, 300);
    const WheelPair before = linked.true_ticks;
    linked.drive_for(duration, left_m_s, right_m_s);
    if (!linked.link.armed()) linked.link.arm();  // a quick reversal is an overcurrent
    travelled_ticks += 0.5 * (std::abs(linked.true_ticks.left - before.left) +
                              std::abs(linked.true_ticks.right - before.right));
    ticks += duration;
  }
  return error_ticks(linked, linked.drive_for(60, 0.0, 0.0)) / travelled_ticks;
}

}  // namespace

TEST_CASE("The travel of a reverse run and its stop is true to four ticks and one sample") {
  for (const Robot& robot : robots()) {
    for (const double v : speeds_m_s) {
      INFO(name(robot) << " at " << v);
      CHECK(worst_error_ticks(robot, [&](LinkedRobot& linked) { linked.drive_for(100, -v, -v); }) <=
            4.0 + ticks_in_a_sample(v));
    }
  }
}

TEST_CASE("The travel of a forward run and its stop is true to four ticks and one sample") {
  for (const Robot& robot : robots()) {
    for (const double v : speeds_m_s) {
      INFO(name(robot) << " at " << v);
      CHECK(worst_error_ticks(robot, [&](LinkedRobot& linked) { linked.drive_for(100, v, v); }) <=
            4.0 + ticks_in_a_sample(v));
    }
  }
}

// A robot may change the way it counts within a sample: what it counted up and down there cannot be told
// apart.
TEST_CASE("A reversal without a rest, and the stop that overcurrent forces, cost at most three samples") {
  for (const Robot& robot : robots()) {
    for (const double v : speeds_m_s) {
      INFO(name(robot) << " at " << v);
      CHECK(worst_error_ticks(robot, [&](LinkedRobot& linked) {
              linked.drive_for(80, v, -v);
              linked.drive_for(80, -v, v);
            }) <= 6.0 + 3.0 * ticks_in_a_sample(v));
    }
  }
}

TEST_CASE("A minute of random commands with reversals keeps travel to one per cent or little more") {
  for (const Robot& robot : robots()) {
    INFO(name(robot));
    const bool counts_as_motor_pushes = robot.sign == EncoderSign::motor_drive;
    CHECK(share_of_random_travel_in_error(robot) <= (counts_as_motor_pushes ? 0.015 : 0.01));
  }
}

TEST_CASE("Worn motors that creep and rock after a stop cost more, and stay within four per cent") {
  const Robot worn{"old_motors.yaml", EncoderSign::command};
  CHECK(share_of_random_travel_in_error(worn) <= 0.04);
}

TEST_CASE("While it turns round again and again within a coast, travel stays near the truth") {
  for (const Robot& robot : robots()) {
    INFO(name(robot));
    CHECK(worst_error_ticks(robot, [&](LinkedRobot& linked) {
            for (int i = 0; i < 10; ++i) {
              linked.drive_for(6, 0.2, -0.2);
              linked.drive_for(6, -0.2, 0.2);
            }
          }) <= 60.0);
  }
}

// Where the predictor says that a robot comes to rest, and the heading that it is steered by.
#include "model/simulation/motion_predictor.hpp"

#include <algorithm>
#include <cmath>

#include "model/route/route_follower.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double lag_s = 0.04;

RobotModel robot_with(const std::vector<EffectSetting>& effects) {
  RobotModel model;
  const double share = -std::expm1(-period_s / lag_s);
  model.linear_part = {
      ModelType::arma, period_s, 0.235, {{share}, {0.0}, {1.0 - share}}, {{0.0}, {share}, {1.0 - share}}};
  for (const auto& effect : effects) model.effects.emplace_back().setting = effect;
  return model;
}

const EffectSetting coasting{"asymmetric_response", "motor_coasting", {1.5, lag_s, 0.45, 3.0}};

const EffectSetting stiff_caster{"caster_kick", "swivel_at_wheels", {0.027, 0.012, 0.13, lag_s, 0.5}};

void drive(MotionPredictor& robot, const WheelPair& speed_m_s, int periods) {
  for (int k = 0; k < periods; ++k) robot.step(robot.command_for(speed_m_s));
}

double heading_after(MotionPredictor robot, const WheelPair& speed_m_s) {
  drive(robot, speed_m_s, 120);
  return robot.pose().theta_rad;
}

}  // namespace

TEST_CASE("A robot that is told to stop comes to rest where the predictor said") {
  for (const auto& effects : {std::vector<EffectSetting>{},
                              {coasting},
                              {{"coulomb_friction", "", {0.01, lag_s}}},
                              {{"saturation", "speed", {0.2, 0.1, 0.0}}}}) {
    MotionPredictor robot(robot_with(effects));
    drive(robot, {0.14, 0.2}, 100);
    const Pose rest = robot.rest_pose();
    drive(robot, {}, 120);
    CHECK_THAT(rest.x_m, WithinAbs(robot.pose().x_m, 1e-4));
    CHECK_THAT(rest.y_m, WithinAbs(robot.pose().y_m, 1e-4));
  }
}

TEST_CASE("A turn that a long delay still holds back is not overlooked on a straight way") {
  const EffectSetting delay{"transport_delay", "", {0.2}};
  MotionPredictor robot(robot_with({delay, coasting, stiff_caster}));
  REQUIRE(robot.limits().straightening_periods > 0);
  drive(robot, {0.2, 0.2}, 200);
  const double straight_rad = robot.rest_pose().theta_rad;
  drive(robot, {0.15, 0.25}, 6);  // shows after 0.2 s
  REQUIRE_THAT(robot.pose().theta_rad, WithinAbs(straight_rad, 1e-3));
  CHECK(robot.rest_pose().theta_rad > straight_rad + 0.01);
}

TEST_CASE("A turn that ends alike whether the robot stops or goes straight is not simulated twice") {
  CHECK(MotionPredictor(robot_with({})).limits().straightening_periods == 0);
  CHECK(
      MotionPredictor(robot_with({{"coulomb_friction", "", {0.01, lag_s}}})).limits().straightening_periods ==
      0);
  CHECK(MotionPredictor(robot_with({{"yaw_bias", "moving", {0.05}}})).limits().straightening_periods == 0);
}

TEST_CASE(
    "A robot with a stiff caster and motors that cannot brake is steered by the heading with which it goes "
    "on straight") {
  MotionPredictor robot(robot_with({coasting, stiff_caster}));
  drive(robot, {0.15, 0.25}, 100);
  const double turning_rad = robot.pose().theta_rad;
  const double straight_rad = heading_after(robot, {0.2, 0.2}) - turning_rad;
  const double stopped_rad = heading_after(robot, {}) - turning_rad;
  CHECK(straight_rad > 2.0 * stopped_rad);
  // The end of the turn, which is slow, is left out.
  CHECK_THAT(robot.rest_pose().theta_rad - turning_rad, WithinRel(straight_rad, 0.3));
}

TEST_CASE("A robot that turns in place is steered by the heading at which it stops") {
  MotionPredictor robot(robot_with({coasting}));
  drive(robot, {-0.1, 0.1}, 100);
  CHECK_THAT(robot.rest_pose().theta_rad, WithinAbs(heading_after(robot, {}), 1e-4));
}

TEST_CASE("A robot whose turn goes on when it is told to go straight stops at slight corners") {
  const auto slowest_near_corner_m_s = [](const std::vector<EffectSetting>& effects) {
    MotionPredictor robot(robot_with(effects));
    RouteFollower follower({"corner", 0.2, 0.02, {{1.0, 0.0}, {2.0, 0.5}}}, {});
    double slowest_m_s = 1.0;
    while (!follower.finished()) {
      robot.step(robot.command_for(follower.steer(robot.rest_pose(), robot.limits())));
      if (std::hypot(robot.pose().x_m - 1.0, robot.pose().y_m) < 0.1)
        slowest_m_s = std::min(slowest_m_s, robot.motion().twist.v_m_s);
    }
    return slowest_m_s;
  };
  CHECK(slowest_near_corner_m_s({}) > 0.15);
  CHECK(slowest_near_corner_m_s({coasting, stiff_caster}) < 0.02);
}

TEST_CASE("A robot with a stiff caster and motors that cannot brake does not swing about its way for ever") {
  MotionPredictor robot(robot_with({coasting, stiff_caster}));
  RouteFollower follower({"corner", 0.2, 0.02, {{1.0, 0.0}, {4.0, 2.1}}}, {});
  double off_leg_rad = 0.0;  // two metres behind the corner
  while (!follower.finished()) {
    robot.step(robot.command_for(follower.steer(robot.rest_pose(), robot.limits())));
    if (robot.pose().x_m > 2.6 && robot.pose().x_m < 3.8)
      off_leg_rad = std::max(off_leg_rad, std::abs(robot.pose().theta_rad - std::atan2(2.1, 3.0)));
  }
  CHECK(off_leg_rad < 0.01);
}

TEST_CASE("A robot whose commands act in steps drives as planned though the model knows their edges badly") {
  constexpr double step_m_s = 0.0285;
  constexpr double rises_at = 0.5;
  constexpr double resolution_m_s = 0.001;  // of the commands that can be sent
  const auto rounded = [](double command_m_s) {
    return resolution_m_s * std::round(command_m_s / resolution_m_s);
  };
  for (const double believed : {0.4, 0.48, 0.52, 0.6}) {
    MotionPredictor robot(robot_with({{"command_quantization", "", {step_m_s, rises_at}}}));
    MotionPredictor model(robot_with({{"command_quantization", "", {step_m_s, believed}}}));
    RouteFollower follower({"square", 0.2, 0.02, {{1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}}, {});
    while (!follower.finished()) {
      const WheelPair command_m_s = model.command_for(follower.steer(model.rest_pose(), model.limits()));
      const WheelPair sent_m_s{rounded(command_m_s.left), rounded(command_m_s.right)};
      model.step(sent_m_s);
      robot.step(sent_m_s);
    }
    INFO("the model has them at " << believed);
    CHECK(std::hypot(robot.pose().x_m, robot.pose().y_m) < 0.005);
  }
}

#include "model/adaptation/model_trial.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double metres_per_tick = 0.00044;

RobotModel wheels_of_gain(double left, double right) {
  RobotModel model;
  model.linear_part.left.from_left = {0.0, 0.5 * left, 0.5 * left};
  model.linear_part.right.from_right = {0.0, 0.5 * right, 0.5 * right};
  model.linear_part.left.from_right = model.linear_part.right.from_left = {0.0, 0.0, 0.0};
  model.encoder_scale = EncoderScale{{metres_per_tick, metres_per_tick}, 1677.0, 0.001};
  return model;
}

// Both wheels of the robot go 2 % less far than the present model says, over legs and turns of varied length.
bool is_better(const RobotModel& candidate) {
  const RobotModel robot = wheels_of_gain(0.98, 0.98);
  ModelTrial trial(wheels_of_gain(1.0, 1.0), candidate);
  ModelSimulation simulation(robot);
  WheelPair rolled_m;
  SensorFrame frame;
  frame.valid = frame.armed = true;
  for (int k = 0; k < 3000; ++k) {
    frame.tick = k;
    frame.ticks = {std::lround(rolled_m.left / metres_per_tick),
                   std::lround(rolled_m.right / metres_per_tick)};
    const bool turns = k % 330 > 270;
    frame.command.speed_m_s = turns ? WheelPair{-0.1, 0.1} : WheelPair{0.2, 0.2};
    trial.take(frame, true);
    const WheelPair speed = simulation.step(frame.command.speed_m_s).wheel_m_s;
    rolled_m.left += robot.linear_part.period_s * speed.left;
    rolled_m.right += robot.linear_part.period_s * speed.right;
  }
  REQUIRE(trial.blocks() > 10);
  return trial.is_better();
}

}  // namespace

TEST_CASE("A model that is right about both wheels takes the place of one that is 2 % off") {
  CHECK(is_better(wheels_of_gain(0.98, 0.98)));
  CHECK_FALSE(is_better(wheels_of_gain(1.02, 1.02)));
}

TEST_CASE("A model that is nearer in travel but turns astray does not") {
  // The travel of one wheel is right now, that of the other as wrong as before; the robot went straight by
  // both models' present wheels, and does not by these.
  CHECK_FALSE(is_better(wheels_of_gain(0.98, 1.0)));
}

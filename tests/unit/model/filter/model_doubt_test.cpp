// Where a small error of a parameter makes a large difference, and what the filter makes of it.
#include <cmath>
#include <limits>

#include "model/filter/hybrid_filter.hpp"
#include "model/filter/model_doubt.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double metres_per_tick = 0.000445;
constexpr double step_m_s = 0.0285;
constexpr double rises_at = 0.5;
constexpr double no_battery_v = std::numeric_limits<double>::quiet_NaN();

AddedEffect effect_with(EffectSetting setting, double half_width) {
  std::vector<ParameterInterval> intervals;
  for (const double value : setting.parameters) intervals.push_back({value - half_width, value + half_width});
  return {std::move(setting), std::move(intervals), {}, {}, {}, {}};
}

RobotModel model_with(AddedEffect effect) {
  RobotModel model;
  model.linear_part.period_s = period_s;
  model.linear_part.wheel_base_m = 0.235;
  model.linear_part.left.from_left = {0.0, 0.0, 0.3, 0.4, 0.3};
  model.linear_part.right.from_right = {0.0, 0.0, 0.3, 0.4, 0.3};
  model.encoder_scale = EncoderScale{{metres_per_tick, metres_per_tick}, 1660.0, 0.001};
  model.effects.push_back(std::move(effect));
  return model;
}

// The step is known to 0.1 mm/s, the place of its edge to a hundredth of it.
RobotModel model_in_steps(double rises) {
  AddedEffect effect = effect_with({"command_quantization", "", {step_m_s, rises}}, 0.01);
  effect.intervals[0] = {step_m_s - 1e-4, step_m_s + 1e-4};
  return model_with(std::move(effect));
}

// After a second of driving straight by one command.
WheelPair doubt_at(const RobotModel& model, double command_m_s) {
  ModelSimulation simulation(model);
  ModelDoubt doubt(model);
  WheelPair doubt_m_s;
  for (int k = 0; k < 60; ++k) {
    const WheelPair& speed = simulation.step({command_m_s, command_m_s}).wheel_m_s;
    doubt_m_s = doubt.step({command_m_s, command_m_s}, no_battery_v, speed);
  }
  return doubt_m_s;
}

}  // namespace

TEST_CASE(
    "At the edge of a step the model is in doubt by the height of the step, and between edges it is not") {
  const RobotModel model = model_in_steps(rises_at);
  const double edge_m_s = 6.5 * step_m_s;
  for (const double beside_m_s : {-2e-4, 2e-4}) {
    const WheelPair doubt = doubt_at(model, edge_m_s + beside_m_s);
    CHECK_THAT(doubt.left, WithinAbs(step_m_s, 0.1 * step_m_s));
    CHECK(doubt.left == doubt.right);
  }
  CHECK(doubt_at(model, 6.0 * step_m_s).left < 0.02 * step_m_s);
}

TEST_CASE("A parameter that changes the speed smoothly causes no doubt") {
  const RobotModel model = model_with(effect_with({"coulomb_friction", "", {0.012, 0.05}}, 0.004));
  CHECK(doubt_at(model, 0.2).left < 1e-4);
  RobotModel linear = model;
  linear.effects.clear();
  CHECK(doubt_at(linear, 0.2).left == 0.0);
}

TEST_CASE("Commands at the edge of a step cause no alarm, and a jump of the counter there still does") {
  const RobotModel model = model_in_steps(rises_at);
  const RobotModel robot = model_in_steps(rises_at - 0.006);
  const double edge_m_s = 6.5 * step_m_s;
  ModelSimulation simulation(robot);
  HybridFilter filter(model);
  WheelPair command;
  bool found = false;
  constexpr int jump_tick = 4000;
  for (int tick = 0; tick < 4200; ++tick) {
    if (tick > 0) simulation.step(command);
    // Every second for one second across the robot's edge and before the model's.
    const double straight_m_s = (tick / 55) % 2 == 0 ? 0.2 : edge_m_s - 1e-4;
    command = {straight_m_s, straight_m_s};
    SensorFrame frame;
    frame.tick = tick;
    frame.t_s = period_s * tick;
    frame.command.speed_m_s = command;
    frame.armed = true;
    frame.valid = true;
    const int jump = tick < jump_tick ? 0 : 70;
    frame.ticks = {std::llround(simulation.distance_m().left / metres_per_tick) + jump,
                   std::llround(simulation.distance_m().right / metres_per_tick)};
    frame.counted_ticks = frame.ticks;
    const HybridOutput out = filter.step(frame);
    CAPTURE(tick, out.left.innovation_m);
    if (tick < jump_tick) REQUIRE(out.events.empty());
    found = found || !out.events.empty();
  }
  CHECK(found);
}

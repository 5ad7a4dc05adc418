// The hybrid filter of a model with effects: what was found missing filters, too.
#include <array>
#include <cmath>

#include "model/filter/hybrid_filter.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double metres_per_tick = 0.000445;

RobotModel model_with(std::vector<EffectSetting> effects) {
  RobotModel model;
  model.linear_part.period_s = period_s;
  model.linear_part.wheel_base_m = 0.235;
  model.linear_part.left.from_left = {0.0, 0.0, 0.3, 0.4, 0.3};
  model.linear_part.right.from_right = {0.0, 0.0, 0.3, 0.4, 0.3};
  model.encoder_scale = EncoderScale{{metres_per_tick, metres_per_tick}, 1660.0, 0.001};
  for (auto& effect : effects) model.effects.push_back({std::move(effect), {}, {}, {}, {}, {}});
  return model;
}

RobotModel without_effects(RobotModel model) {
  model.effects.clear();
  return model;
}

// Forward at changing speeds, with arcs to the left.
WheelPair command_at(int tick) {
  constexpr std::array<WheelPair, 5> speeds{{{0.2, 0.2}, {0.1, 0.2}, {0.15, 0.15}, {0.05, 0.15}, {0.3, 0.3}}};
  return speeds.at(static_cast<std::size_t>(tick / 150) % speeds.size());
}

struct Drive {
  std::vector<SensorFrame> frames;
  Pose end;
};

// Frames of a robot that does as a model says; counts are whole ticks.
Drive drive_of(const RobotModel& robot, int ticks) {
  ModelSimulation simulation(robot);
  Drive drive;
  WheelPair command;
  for (int tick = 0; tick < ticks; ++tick) {
    if (tick > 0) simulation.step(command);
    command = command_at(tick);
    SensorFrame frame;
    frame.tick = tick;
    frame.t_s = period_s * tick;
    frame.command.speed_m_s = command;
    frame.armed = true;
    frame.valid = true;
    frame.ticks = {std::llround(simulation.distance_m().left / metres_per_tick),
                   std::llround(simulation.distance_m().right / metres_per_tick)};
    frame.counted_ticks = frame.ticks;
    drive.frames.push_back(frame);
    drive.end = simulation.pose();
  }
  return drive;
}

struct Filtered {
  Pose end;
  int discarded = 0;
  double innovation_m = 0.0;  // root mean square, left wheel
};

Filtered filtered(const RobotModel& model, const Drive& drive) {
  HybridFilter filter(model);
  Filtered result;
  double squares = 0.0;
  for (const SensorFrame& frame : drive.frames) {
    const HybridOutput out = filter.step(frame);
    result.discarded += out.left.discarded || out.right.discarded ? 1 : 0;
    squares += out.left.innovation_m * out.left.innovation_m;
  }
  result.end = filter.pose();
  result.innovation_m = std::sqrt(squares / static_cast<double>(drive.frames.size()));
  return result;
}

}  // namespace

TEST_CASE("What the wheels do by an effect is predicted, so that sound counts are not held for a fault") {
  const auto robot =
      model_with({{"saturation", "command", {0.22, 0.0, 0.05}}, {"coulomb_friction", "", {0.012, 0.05}}});
  const auto drive = drive_of(robot, 3000);
  const auto whole = filtered(robot, drive);
  const auto linear = filtered(without_effects(robot), drive);
  CAPTURE(whole.innovation_m, linear.innovation_m, whole.discarded, linear.discarded);
  CHECK(whole.discarded == 0);
  CHECK(linear.discarded > 100);
  CHECK(whole.innovation_m < 0.2 * linear.innovation_m);
}

TEST_CASE("What the body does beyond its wheels is part of the filtered pose") {
  const auto robot = model_with({{"effective_track", "", {0.012}}});
  const auto drive = drive_of(robot, 3000);
  const auto whole = filtered(robot, drive);
  const auto linear = filtered(without_effects(robot), drive);
  CAPTURE(distance_between_m(whole.end, drive.end), distance_between_m(linear.end, drive.end));
  CHECK(distance_between_m(whole.end, drive.end) < 0.01);
  CHECK(distance_between_m(linear.end, drive.end) > 0.1);
  CHECK(std::abs(whole.end.theta_rad - drive.end.theta_rad) < 0.01);
}

TEST_CASE("A fault is found beside effects as without them") {
  const auto robot = model_with({{"coulomb_friction", "", {0.012, 0.05}}});
  auto drive = drive_of(robot, 3000);
  for (std::size_t k = 1500; k < drive.frames.size(); ++k) drive.frames[k].ticks.left -= 60;
  HybridFilter filter(robot);
  bool found = false;
  for (const SensorFrame& frame : drive.frames) {
    const HybridOutput out = filter.step(frame);
    if (frame.tick < 1500) REQUIRE(out.events.empty());
    found = found || !out.events.empty();
  }
  CHECK(found);
  CHECK(distance_between_m(filter.pose(), drive.end) < 0.02);
}

TEST_CASE("A filter of a model with effects is copied with its motion") {
  const auto robot = model_with({{"coulomb_friction", "", {0.012, 0.05}}});
  const auto drive = drive_of(robot, 600);
  HybridFilter first(robot);
  for (int k = 0; k < 300; ++k) first.step(drive.frames[static_cast<std::size_t>(k)]);
  HybridFilter second = first;
  for (std::size_t k = 300; k < drive.frames.size(); ++k) {
    REQUIRE(first.step(drive.frames[k]).left.innovation_m == second.step(drive.frames[k]).left.innovation_m);
  }
}

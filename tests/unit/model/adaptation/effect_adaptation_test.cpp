// A model with effects, kept up to date while its robot's friction changes.
#include "model/adaptation/continuous_calibration.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/dry_friction_drive.hpp"

using namespace wheelwright;

namespace {

constexpr double friction_m_s = 0.012;

struct Adapted {
  RobotModel model;
  double found_s = 0.0;
};

std::optional<Adapted> first_adapted(const RobotModel& model, const std::vector<SensorFrame>& frames) {
  ContinuousCalibration calibration(model);
  for (const SensorFrame& frame : frames) {
    if (auto found = calibration.take(frame)) return Adapted{*found, 0.018 * static_cast<double>(frame.tick)};
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("Friction that doubles on the way is learnt within 40 s, and the linear part stays") {
  const test::DryFrictionRobot robot;
  const RobotModel model = test::dry_friction_model(robot, friction_m_s);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    const auto frames = test::dry_friction_drive(robot, friction_m_s, 2.0 * friction_m_s, 60.0, 140.0, seed);
    const auto adapted = first_adapted(model, frames);
    REQUIRE(adapted);
    CHECK(adapted->found_s > 60.0);
    CHECK(adapted->found_s < 100.0);
    const AddedEffect& effect = adapted->model.effects.front();
    CHECK_THAT(effect.setting.parameters[0], WithinAbs(2.0 * friction_m_s, 0.2 * friction_m_s));
    CHECK(effect.intervals[0].lower < effect.setting.parameters[0]);
    CHECK(effect.intervals[0].upper > effect.setting.parameters[0]);
    CHECK(effect.setting.parameters[1] == model.effects.front().setting.parameters[1]);
    CHECK_THAT(dc_gain(adapted->model.linear_part.left).from_left, WithinAbs(robot.gain, 0.02));
  }
}

TEST_CASE("A robot with friction that its model knows is driven by that model to the end") {
  const test::DryFrictionRobot robot;
  const auto frames = test::dry_friction_drive(robot, friction_m_s, friction_m_s, 60.0, 300.0, 5);
  CHECK_FALSE(first_adapted(test::dry_friction_model(robot, friction_m_s), frames));
}

TEST_CASE("Effects of the firmware and of the floor are not what counts can change") {
  RobotModel model = test::dry_friction_model({}, friction_m_s);
  model.effects.push_back({{"dead_zone", "", {0.01, 1.0}}, {}, {}, {}, {}, {}});
  model.effects.push_back({{"turn_scrub", "", {0.05, 0.0, 0.0}}, {}, {}, {}, {}, {}});
  ModelAdaptation adaptation(model, ModelSimulation(model));
  for (const SensorFrame& frame : test::dry_friction_drive({}, 0.02, 0.02, 0.0, 30.0, 6))
    adaptation.take(frame, true);
  const RobotModel adapted = adaptation.adapted();
  CHECK(adapted.effects[0].setting.parameters != model.effects[0].setting.parameters);
  CHECK(adapted.effects[1].setting.parameters == model.effects[1].setting.parameters);
  CHECK(adapted.effects[2].setting.parameters == model.effects[2].setting.parameters);
}

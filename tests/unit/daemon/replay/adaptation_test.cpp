// The calibration that never ends, in whole runs: laps by a model that has become wrong.
#include <cmath>

#include "daemon/replay/virtual_run.hpp"
#include "model/adaptation/model_trial.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/outdated_model.hpp"
#include "tests/support/recorded_drive.hpp"

using namespace wheelwright;

namespace {

constexpr int longest_lap_s = 40;

const RobotModel& calibrated() {
  static const RobotModel made = test::calibrated_model("default", "box", 61);
  return made;
}

daemon::VirtualRunResult drive(const RobotModel& model, std::uint64_t seed, int laps, bool adapt = true,
                               const daemon::TickHook& hook = {}) {
  simulation::SimulatedRobot robot(test::robot_on_endless_floor("default", seed));
  daemon::VirtualRunConfig config;
  config.mission.route = Route{"laps", 0.2, 0.02, test::laps(laps)};
  config.mission.pose_source = PoseSource::fir;
  config.mission.adapt = adapt;
  config.model = model;
  config.longest_s = 10.0 + longest_lap_s * laps;
  return daemon::run_virtually(config, robot, hook);
}

// Of the free run over blocks of 2 s, on a drive of another robot of the same make.
double free_run_error_m(const RobotModel& model) {
  static const auto frames = test::record_drive(test::robot_on_endless_floor("default", 72), 72, 40.0).frames;
  ModelTrial trial(model, model);
  for (const SensorFrame& frame : frames) trial.take(frame, true);
  return *trial.present_error_m();
}

std::optional<std::size_t> first_due(const daemon::VirtualRunResult& run) {
  for (std::size_t k = 0; k < run.records.size(); ++k) {
    if (run.records[k].hybrid && run.records[k].hybrid->recalibration_due) return k;
  }
  return std::nullopt;
}

std::size_t exchanges(const daemon::VirtualRunResult& run) {
  std::size_t count = 0;
  for (std::size_t k = 1; k < run.records.size(); ++k) {
    count += run.records[k].model_version != run.records[k - 1].model_version ? 1U : 0U;
  }
  return count;
}

}  // namespace

TEST_CASE("A model that is wrong by 7 per cent is due, and one exchange halves the error of its free run") {
  for (const double factor : {0.93, 1.07}) {
    for (const std::uint64_t seed : {63U, 71U}) {
      INFO("factor " << factor << ", seed " << seed);
      const RobotModel wrong = test::scaled(calibrated(), factor);
      const auto run = drive(wrong, seed, 8);
      REQUIRE(run.finished);
      const auto due = first_due(run);
      REQUIRE(due);
      CHECK(exchanges(run) == 1);
      REQUIRE(run.adapted.size() == 1);
      CHECK(free_run_error_m(run.adapted.back()) < 0.5 * free_run_error_m(wrong));
    }
  }
}

TEST_CASE("A model with effects is adapted while it is driven by, and keeps its effects") {
  RobotModel wrong = test::scaled(calibrated(), 0.93);
  wrong.effects.push_back({{"coulomb_friction", "", {0.002, 0.06}}, {}, {}, {}, {}, {}});
  wrong.effects.push_back({{"turn_scrub", "", {0.02, 0.0, 0.0}}, {}, {}, {}, {}, {}});
  const auto run = drive(wrong, 63, 8);
  REQUIRE(run.finished);
  CHECK(exchanges(run) == 1);
  REQUIRE(run.adapted.size() == 1);
  const RobotModel& adapted = run.adapted.back();
  REQUIRE(adapted.effects.size() == 2);
  CHECK(adapted.effects[1].setting.parameters == wrong.effects[1].setting.parameters);
  CHECK(free_run_error_m(adapted) < 0.5 * free_run_error_m(wrong));
}

TEST_CASE("At an exchange of models the pose goes on where it was, and no command is missing") {
  const auto run = drive(test::scaled(calibrated(), 0.93), 63, 8);
  REQUIRE(exchanges(run) == 1);
  for (std::size_t k = 1; k < run.records.size(); ++k) {
    const PoseRecord& before = run.records[k - 1];
    const PoseRecord& now = run.records[k];
    if (now.command.activity != Activity::route || before.command.activity != Activity::route) continue;
    REQUIRE(now.command.tick == before.command.tick + 1);
    REQUIRE(now.has_prediction);
    // At 0.2 m/s a tick is 3.6 mm; a wheel changes its speed by no jump.
    REQUIRE(distance_between_m(before.predicted, now.predicted) < 0.006);
    REQUIRE(std::abs(now.predicted_speed_m_s.left - before.predicted_speed_m_s.left) < 0.06);
    REQUIRE(distance_between_m(before.hybrid->pose, now.hybrid->pose) < 0.008);
    REQUIRE(now.hybrid->covariance(0, 0) >= 0.0);
  }
}

TEST_CASE("A model that fits is driven by to the end") {
  for (const std::uint64_t seed : {63U, 71U, 72U}) {
    INFO("seed " << seed);
    const auto run = drive(calibrated(), seed, 6);
    REQUIRE(run.finished);
    CHECK_FALSE(first_due(run));
    CHECK(run.adapted.empty());
  }
}

TEST_CASE("Where adapting is switched off a wrong model is told, and nothing else") {
  const auto run = drive(test::scaled(calibrated(), 0.93), 63, 8, false);
  CHECK(first_due(run));
  CHECK(run.adapted.empty());
  CHECK(run.records.back().model_version == 1);
}

TEST_CASE("The same run adapts to the same model at the same tick") {
  const RobotModel wrong = test::scaled(calibrated(), 0.93);
  const auto one = drive(wrong, 63, 8);
  const auto other = drive(wrong, 63, 8);
  REQUIRE(one.adapted.size() == 1);
  CHECK(one.adapted[0].linear_part.left.from_left == other.adapted[0].linear_part.left.from_left);
  CHECK(one.records.size() == other.records.size());
}

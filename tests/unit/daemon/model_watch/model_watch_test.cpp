// The watch over a model: what it says of drives of a robot that has changed since its model was made.
#include "daemon/model_watch/model_watch.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "daemon/model_watch/model_changes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/plant_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fs = std::filesystem;
using namespace wheelwright;
using namespace wheelwright::daemon;

namespace {

constexpr double former_threshold_m_s = 0.02;

// The published plant's own model, behind a dead zone.
RobotModel model_in_use() {
  RobotModel model;
  std::vector<double> from_command{0.0};
  for (const double weight : test::PublishedPlant::input_weights) from_command.push_back(weight);
  const std::vector<double> from_past(test::PublishedPlant::output_weights.begin(),
                                      test::PublishedPlant::output_weights.end());
  const std::vector<double> nothing(from_command.size(), 0.0);
  model.linear_part = {
      ModelType::arma, 0.018, 0.235, {from_command, nothing, from_past}, {nothing, from_command, from_past}};
  model.encoder_scale = EncoderScale{{0.000444565, 0.000444565}, 1660.0, 0.001};
  model.robot = "plant";
  model.created = "2026-11-26T00:00:00Z";
  AddedEffect dead_zone;
  dead_zone.setting = {"dead_zone", "", {former_threshold_m_s, 0.02}};
  dead_zone.intervals = {{0.019, 0.021}, {0.02, 0.05}};
  model.effects.push_back(dead_zone);
  return model;
}

struct Robot {
  test::TemporaryFolder folder{"watched"};
  config::DaemonConfig config;
  fs::path last_run;

  Robot() {
    config.robot_name = "plant";
    config.model_file = folder.path() / "model.yaml";
    config.log_folder = folder.path() / "runs";
    config.pose_source = PoseSource::hybrid;
    config.gap_watch = config::GapWatch::after_run;
    config::save_model(model_in_use(), config.model_file);
  }

  void drives(int count, double threshold_m_s) {
    const auto curve = [&](double command_m_s) {
      return std::abs(command_m_s) < threshold_m_s ? 0.0 : command_m_s;
    };
    for (int i = 1; i <= count; ++i) {
      std::string name = "2026-11-26T14-00-00Z";
      name[15] = static_cast<char>('0' + i);
      last_run = config.log_folder / name;
      fs::create_directories(last_run);
      config::save_drive_log(test::plant_run(static_cast<unsigned>(40 + i), 2000, curve, 25),
                             last_run / "drive_log.csv");
    }
  }

  std::string watched() {
    IdleProcessLimits limits;
    limits.lowest_priority = false;  // other tests run beside it
    ModelWatch watch(config, last_run, limits);
    watch.drive_ended(false);
    sigset_t none;
    sigemptyset(&none);
    watch.wait(none);
    return watch.answer();
  }
};

}  // namespace

TEST_CASE(
    "A dead zone that has grown is said with both sizes, and the proven model takes the place of the "
    "former") {
  Robot robot;
  robot.drives(4, 0.05);
  CHECK_THAT(robot.watched(), ContainsSubstring("dead_zone: threshold rose from 0.02 to 0.0") &&
                                  ContainsSubstring("since 2026-11-26T14:01Z (95 %: 0.0"));
  const RobotModel now = config::load_model(robot.config.model_file);
  REQUIRE(now.effects.size() == 1);
  CHECK_THAT(now.effects[0].setting.parameters[0], WithinAbs(0.05, 0.004));
  const RobotModel former = config::load_model(robot.last_run / "gap" / "former_model.yaml");
  CHECK(former.effects[0].setting.parameters[0] == former_threshold_m_s);
}

TEST_CASE("A model that still holds is said to hold, and stays") {
  Robot robot;
  robot.drives(4, former_threshold_m_s);
  CHECK_THAT(robot.watched(), ContainsSubstring("holds on 4 drives"));
  CHECK(config::load_model(robot.config.model_file).created == model_in_use().created);
}

TEST_CASE("A watch that is off, or that no drive is long enough for, looks at nothing") {
  Robot robot;
  robot.drives(1, 0.05);
  robot.config.gap_watch = config::GapWatch::when_due;
  CHECK(robot.watched().empty());
  robot.config.gap_watch = config::GapWatch::after_run;
  fs::remove(robot.last_run / "drive_log.csv");
  CHECK_THAT(robot.watched(), ContainsSubstring("no drive is recorded"));
}

TEST_CASE("An effect that is gone is named only where the drives would have shown it") {
  const RobotModel before = model_in_use();
  RobotModel after = before;
  after.effects.clear();
  GapAnswer answer;
  CHECK(effect_changes(before, after, answer, "").empty());
  answer.detectable = {{"dead_zone", "threshold", 2.0 * former_threshold_m_s}};
  CHECK(effect_changes(before, after, answer, "").empty());
  answer.detectable = {{"dead_zone", "threshold", 0.5 * former_threshold_m_s}};
  const auto said = effect_changes(before, after, answer, "");
  REQUIRE(said.size() == 1);
  CHECK(said.front() == "dead_zone: is not seen any more");
}

TEST_CASE("A size that one wheel alone has changed is compared with the one that both had") {
  const RobotModel before = model_in_use();
  RobotModel after = before;
  after.effects.front().setting = {"dead_zone", "each_wheel", {former_threshold_m_s, 0.04, 0.02}};
  after.effects.front().intervals = {{0.019, 0.021}, {0.039, 0.041}, {0.02, 0.05}};
  const auto said = effect_changes(before, after, {}, "");
  REQUIRE(said.size() == 1);
  CHECK(said.front().starts_with("dead_zone: threshold_right rose from 0.02 to 0.04 m/s"));
}

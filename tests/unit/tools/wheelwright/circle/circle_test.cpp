// What the circle hides and how it counts what was found; and drives recorded with reference poses.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "config/load/simulation_config.hpp"
#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/circle/circle_report.hpp"
#include "tools/wheelwright/circle/own_imperfections.hpp"
#include "tools/wheelwright/evaluation/learning_drives.hpp"
#include "tools/wheelwright/evaluation/prediction_error.hpp"

using namespace wheelwright;

namespace {

const std::string perfect = WHEELWRIGHT_SOURCE_DIR "/config/robots/perfect.yaml";

tools::HiddenRobot hidden_by(std::uint64_t seed) {
  return tools::pick_hidden_robot(seed, {}, perfect, "room.yaml");
}

}  // namespace

TEST_CASE("A hidden robot is a robot file that loads, and differs from what it is based on") {
  const auto& folder = test::temporary_folder();
  std::set<std::string> kinds;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto hidden = hidden_by(seed);
    std::ofstream(folder / "room.yaml") << hidden.room_yaml;
    std::ofstream(folder / "robot.yaml") << hidden.robot_yaml;
    CHECK_NOTHROW(config::load_simulation_config(folder / "robot.yaml"));
    CHECK((!hidden.imperfections.empty() && hidden.imperfections.size() <= 3));
    for (const auto& imperfection : hidden.imperfections) {
      for (const auto& effect : imperfection.effects) CHECK(find_effect(effect) != nullptr);
      kinds.insert(imperfection.effects.front());
    }
  }
  CHECK(kinds.size() >= 8);
}

TEST_CASE("The same seed hides the same, another one something else") {
  CHECK(hidden_by(3).robot_yaml == hidden_by(3).robot_yaml);
  CHECK(hidden_by(3).robot_yaml != hidden_by(4).robot_yaml);
}

TEST_CASE("A floor that slopes comes with friction that holds the robot on it") {
  const auto hides = [](const tools::HiddenRobot& hidden, const std::string& effect) {
    return std::ranges::any_of(hidden.imperfections, [&](const tools::Imperfection& imperfection) {
      return imperfection.effects.front() == effect;
    });
  };
  bool any = false;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto hidden = hidden_by(seed);
    if (!hides(hidden, "floor_slope")) continue;
    any = true;
    CHECK(hides(hidden, "coulomb_friction"));
  }
  CHECK(any);
}

TEST_CASE("A name counts for what was hidden under it, and else as false") {
  tools::CircleReport report;
  report.hidden = {{"play", {"backlash"}}, {"friction", {"coulomb_friction", "stiction"}}};
  report.named = {"stiction", "saturation"};
  CHECK(tools::naming_score(report).right == 1);
  CHECK(tools::naming_score(report).wrong == 1);
}

TEST_CASE("A scale that the calibration got wrong is rightly named, and nobody has to find it") {
  tools::CircleReport report;
  report.hidden = {{"scrubbing tyres", {"turn_scrub"}}};
  report.named = {"turn_scrub", "distance_scale"};
  CHECK(tools::naming_score(report).wrong == 1);
  const auto error = tools::scale_error(0.000443, 0.000445);
  REQUIRE(error);
  CHECK(error->what == "metres per tick, calibrated 0.45 % too small");
  report.not_hidden = {*error};
  CHECK(tools::naming_score(report).wrong == 0);
  report.named = {"turn_scrub"};
  CHECK(tools::naming_score(report).right == 1);
  CHECK_FALSE(tools::scale_error(0.0004451, 0.000445));
}

TEST_CASE("What a robot has of its own is rightly named, and nobody has to find it") {
  const auto own = [](const std::string& robot) {
    return tools::own_imperfections(
        config::load_simulation_config(WHEELWRIGHT_SOURCE_DIR "/config/robots/" + robot + ".yaml"));
  };
  CHECK(own("perfect").empty());
  tools::CircleReport report;
  report.named = {"command_quantization", "wheel_scale_mismatch"};
  CHECK(tools::naming_score(report).wrong == 2);
  report.not_hidden = own("create2");
  CHECK(tools::naming_score(report).wrong == 0);
}

TEST_CASE("Where no lap came to its end the report says why instead of an offset") {
  tools::CircleReport report;
  report.before.failure = "stopped: bump";
  std::ostringstream out;
  print_circle(out, report);
  CHECK_THAT(out.str(), ContainsSubstring("did not come to its end: stopped: bump"));
}

TEST_CASE(
    "The found model drives only if it predicted its own new drives better, and the report says which "
    "drove") {
  const auto printed = [](const tools::Proof& proof) {
    tools::CircleReport report;
    report.before.offsets_m = report.after.offsets_m = {0.1};
    report.proof = proof;
    std::ostringstream out;
    print_circle(out, report);
    return out.str();
  };
  const tools::OwnDrives close{0.028, 0, ""};
  const tools::OwnDrives far{0.090, 0, ""};
  const tools::OwnDrives none{{}, 2, "stopped: bump"};
  CHECK_THAT(printed({far, close}), ContainsSubstring("the found model drives") &&
                                        ContainsSubstring("B, with what the workflow added"));
  CHECK_THAT(printed({close, far}), ContainsSubstring("the calibrated model drives") &&
                                        ContainsSubstring("B, by the calibrated model"));
  CHECK_THAT(printed({far, none}),
             ContainsSubstring("found 2 stopped (stopped: bump); the calibrated model drives"));
  CHECK_THAT(printed({none, far}), ContainsSubstring("the found model drives"));
  CHECK_FALSE(tools::Proof{none, none}.is_better());
}

TEST_CASE("A found model that is stopped more often than the calibrated one does not drive") {
  CHECK_FALSE(tools::Proof{{0.090, 0, ""}, {0.028, 1, "stopped: bump"}}.is_better());
  CHECK(tools::Proof{{0.090, 1, "stopped: bump"}, {0.028, 1, "stopped: bump"}}.is_better());
}

TEST_CASE("Of two models the one that is right is closer to the reference over a whole drive") {
  auto robot = config::load_simulation_config(perfect);
  tools::RobotTrial trial(robot, RobotLimits{}, roomba::LinkConfig{}, simulation::Noise(1));
  const auto model = trial.calibrate_response({});
  REQUIRE(model);
  Mission mission;
  mission.route = Route{"angle", 0.2, 0.02, {{0.5, 0.0}, {0.5, 0.5}}};
  const auto log = trial.record(mission, *model, {0.0, 0.0});
  REQUIRE(log);
  RobotModel wrong = *model;
  for (double& weight : wrong.linear_part.left.from_left) weight *= 1.03;
  const auto error_m = [&](const RobotModel& of) { return tools::position_error_m(of, std::span(&*log, 1)); };
  CHECK(*error_m(*model) < 0.5 * *error_m(wrong));
  DriveLog without_reference = *log;
  for (DriveSample& sample : without_reference.samples) sample.reference_x_m.reset();
  CHECK_FALSE(tools::position_error_m(*model, std::span(&without_reference, 1)));
}

TEST_CASE("A recorded experiment holds its commands as they stand") {
  auto robot = config::load_simulation_config(perfect);
  tools::RobotTrial trial(robot, RobotLimits{}, roomba::LinkConfig{}, simulation::Noise(1));
  const auto model = trial.calibrate_response({});
  REQUIRE(model);
  Mission mission;
  mission.commanded_drive = CommandedDrive{"both ways", {{0.0, {0.1, 0.1}}, {2.0, {-0.1, -0.1}}}, 4.0};
  const auto log = trial.record(mission, *model, {0.0, 0.0});
  REQUIRE(log);
  CHECK(log->samples.size() == 222);
  CHECK(log->samples.front().command_m_s.left == 0.1);
  CHECK(log->samples.back().command_m_s.right == -0.1);
  CHECK_THAT(*log->samples[111].reference_x_m, WithinAbs(0.19, 0.02));
  CHECK_THAT(*log->samples.back().reference_x_m, WithinAbs(0.0, 0.03));
}

TEST_CASE("A recorded drive holds commands, counts and a reference that agree") {
  auto robot = config::load_simulation_config(perfect);
  tools::RobotTrial trial(robot, RobotLimits{}, roomba::LinkConfig{}, simulation::Noise(1));
  const auto model = trial.calibrate_response({});
  REQUIRE(model);
  Mission mission;
  mission.route = Route{"leg", 0.2, 0.02, {{0.5, 0.0}}};
  const auto log = trial.record(mission, *model, {0.0, 0.0});
  REQUIRE(log);
  const auto& first = log->samples.front();
  const auto& last = log->samples.back();
  CHECK(*first.reference_x_m == 0.0);
  CHECK_THAT(*last.reference_x_m, WithinAbs(0.5, 0.02));
  const auto counted = static_cast<double>(last.ticks->left - first.ticks->left);
  CHECK_THAT(counted * log->metres_per_tick->left, WithinAbs(*last.reference_x_m, 0.01));
}

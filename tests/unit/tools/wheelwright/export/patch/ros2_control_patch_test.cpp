// Numbers of a model put into a YAML file of ros2_control or Nav2 that is there already.
#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/support/exported_model.hpp"
#include "tests/support/patch_case.hpp"
#include "tools/wheelwright/export/ros2_control.hpp"

using namespace wheelwright;
using test::PatchCase;
using tools::ExitStatus;

namespace {

const std::string controller =
    "# my robot\n"
    "controller_manager:\n"
    "  ros__parameters:\n"
    "    update_rate: 50   # Hz\n"
    "    base: {type: diff_drive_controller/DiffDriveController}\n"
    "\n"
    "base:\n"
    "  ros__parameters:\n"
    "    left_wheel_names: [\"left\"]\n"
    "    right_wheel_names: [\"right\"]\n"
    "    wheel_separation: 0.24      # by tape\n"
    "    wheel_radius: 0.036\n"
    "    pose_covariance_diagonal: [0.001, 0.001, 0.5,\n"
    "                               0.0, 0.0, 0.01]\n"
    "    linear:\n"
    "      x:\n"
    "        max_velocity: 1.0\n"
    "\n"
    "    publish_rate: 50.0";

const std::string smoother =
    "velocity_smoother:\n"
    "  ros__parameters:\n"
    "    smoothing_frequency: 20.0\n"
    "    max_velocity: [0.5, 0.0, 2.5]\n"
    "    deadband_velocity:\n"
    "      - 0.0\n"
    "      - 0.0\n"
    "      - 0.0\n"
    "    max_accel: [2.5, 0.0, 3.2]\n";

const std::vector<std::string> radius{"--wheel-radius", "0.036"};

RobotModel with_drift() {
  RobotModel model = test::model_with_effects();
  model.left_fit = model.right_fit = WheelFit{};
  model.left_fit->drift_m_per_sqrt_s = 0.003;
  model.right_fit->drift_m_per_sqrt_s = 0.004;
  return model;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

void refused(const std::string& text, const std::vector<std::string>& more, const std::string& what) {
  const PatchCase robot_case("ros2_patch_refused", with_drift(), text);
  auto options = radius;
  options.insert(options.end(), more.begin(), more.end());
  const auto outcome = robot_case.run("ros2_control", options);
  INFO(what << "\n" << outcome.err << outcome.out);
  CHECK(outcome.status == ExitStatus::bad_input);
  CHECK(test::is_one_line(outcome.err));
  CHECK_THAT(outcome.err, ContainsSubstring(what));
  CHECK(robot_case.text() == text);
}

}  // namespace

TEST_CASE(
    "A patch of a controller's YAML changes values, adds keys where their levels are, and keeps the rest") {
  const PatchCase patched("ros2_patch", with_drift(), controller);
  const auto outcome = patched.run("ros2_control", radius);
  INFO(outcome.err << outcome.out << patched.text());
  REQUIRE(outcome.status == ExitStatus::done);
  const std::string text = patched.text();
  CHECK_THAT(text,
             ContainsSubstring("    wheel_separation: 0.25      # by tape  # wheelwright: as the logs"));
  CHECK_THAT(text,
             ContainsSubstring("    base: {type: diff_drive_controller/DiffDriveController}\n\nbase:\n"));
  CHECK_THAT(text,
             ContainsSubstring("wheel_separation_multiplier: 1.04  # wheelwright: 95 % interval 1.036"));
  CHECK_THAT(outcome.out, ContainsSubstring("base linear.x.max_velocity: changed from 1.0 to 0.4"));
  CHECK_THAT(outcome.out, ContainsSubstring("velocity_smoother max_velocity: [0.4, 0.0, "));
  const YAML::Node base = YAML::Load(text)["base"]["ros__parameters"];
  CHECK_THAT(base["linear"]["x"]["min_acceleration"].as<double>(), WithinAbs(-0.8, 1e-9));
  CHECK_THAT(base["angular"]["z"]["max_velocity"].as<double>(), WithinAbs(0.8 / 0.26, 1e-8));
  CHECK_THAT(base["pose_covariance_diagonal"][5].as<double>(), WithinAbs(25e-6 / 0.0625, 1e-9));
  CHECK_THAT(base["publish_rate"].as<double>(), WithinAbs(50.0, 1e-9));
  CHECK_THAT(patched.run("ros2_control", radius).out, ContainsSubstring("nothing to change"));
  CHECK(patched.text() == text);
}

TEST_CASE("A smoother of Nav2 is patched by itself, in lists of either style") {
  const PatchCase patched("ros2_patch_smoother", with_drift(), smoother);
  const auto outcome = patched.run("ros2_control", radius);
  INFO(outcome.err << outcome.out << patched.text());
  REQUIRE(outcome.status == ExitStatus::done);
  const YAML::Node node = YAML::Load(patched.text())["velocity_smoother"]["ros__parameters"];
  CHECK_THAT(node["deadband_velocity"][0].as<double>(), WithinAbs(0.03, 1e-9));
  CHECK_THAT(node["max_velocity"][0].as<double>(), WithinAbs(0.4, 1e-9));
  CHECK_THAT(node["max_decel"][0].as<double>(), WithinAbs(-0.8, 1e-9));
  CHECK_THAT(outcome.out,
             ContainsSubstring("deadband_velocity: changed from [0.0, 0.0, 0.0] to [0.03, 0.0,"));
  CHECK_THAT(patched.run("ros2_control", radius).out, ContainsSubstring("nothing to change"));
}

TEST_CASE("What export writes as a new file, a patch with the same model leaves as it is") {
  const PatchCase patched("ros2_patch_new", with_drift(), tools::to_ros2_control(with_drift(), 0.036).text);
  const auto outcome = patched.run("ros2_control", radius);
  INFO(outcome.err << outcome.out);
  CHECK_THAT(outcome.out, ContainsSubstring("nothing to change"));
}

TEST_CASE("Keys with dots, windows line ends and comments of another model are met as they are") {
  std::string text = replaced(controller, "    linear:\n      x:\n        max_velocity: 1.0\n",
                              "    linear.x.max_velocity: 1.0 # wheelwright: old\n");
  text = replaced(text, "# by tape", "# by tape # wheelwright: older");
  std::string windows;
  for (const char letter : text) windows += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  const PatchCase patched("ros2_patch_dots", with_drift(), windows);
  const auto outcome = patched.run("ros2_control", radius);
  INFO(outcome.err << outcome.out << patched.text());
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(patched.text(), ContainsSubstring("linear.x.max_velocity: 0.4  # wheelwright: 95 % interval"));
  CHECK_THAT(patched.text(), !ContainsSubstring("wheelwright: old"));
  CHECK_THAT(patched.text(), ContainsSubstring("# by tape  # wheelwright: as the logs give it\r\n"));
  CHECK(std::ranges::count(patched.text(), '\r') == std::ranges::count(patched.text(), '\n'));
  CHECK_THAT(patched.run("ros2_control", radius).out, ContainsSubstring("nothing to change"));
}

TEST_CASE(
    "A limit that is tighter than the robot's own is kept and told, as what the model says nothing of is") {
  const std::string tight = replaced(controller, "max_velocity: 1.0", "max_velocity: 0.1");
  const PatchCase patched("ros2_patch_tight", with_drift(), tight + "\n" + smoother);
  const auto outcome = patched.run("ros2_control", radius);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(outcome.out, ContainsSubstring("max_velocity: kept at 0.1; tighter than the robot's own 0.4"));
  CHECK_THAT(outcome.out,
             ContainsSubstring("max_velocity: changed from [0.5, 0.0, 2.5] to [0.4, 0.0, 2.5]; tighter"));
  CHECK_THAT(patched.text(),
             ContainsSubstring("max_velocity: 0.1  # wheelwright: the robot reaches 0.4: 95 % interval"));
  const YAML::Node base = YAML::Load(patched.text())["base"]["ros__parameters"];
  CHECK_THAT(base["pose_covariance_diagonal"][2].as<double>(), WithinAbs(0.5, 1e-12));
  CHECK_THAT(base["pose_covariance_diagonal"][4].as<double>(), WithinAbs(0.0, 1e-12));
  CHECK_THAT(patched.run("ros2_control", radius).out, ContainsSubstring("nothing to change"));
}

TEST_CASE("A key that is added stands as its neighbours do, with dots or in levels") {
  const PatchCase patched("ros2_patch_flat", with_drift(),
                          replaced(controller, "    linear:\n      x:\n        max_velocity: 1.0\n",
                                   "    linear.x.max_jerk: 1.0\n"));
  REQUIRE(patched.run("ros2_control", radius).status == ExitStatus::done);
  CHECK_THAT(patched.text(), ContainsSubstring("\n    linear.x.min_velocity: -0.4\n"));
  CHECK_THAT(patched.text(),
             ContainsSubstring("\n    angular:\n      z:\n        has_velocity_limits: true\n"));
  CHECK_THAT(patched.run("ros2_control", radius).out, ContainsSubstring("nothing to change"));
}

TEST_CASE("A YAML file without the place for the numbers is left as it is, and told what it lacks") {
  refused(
      "a:\n  ros__parameters:\n    b: 1\n", {},
      "has no diff_drive_controller (ros__parameters with wheel_separation); nodes with ros__parameters: a");
  refused(controller, {"--within", "other"}, "has no diff_drive_controller of the name other");
  refused(controller + "\n" + replaced(controller.substr(controller.find("base:\n")), "base", "second"), {},
          "has several nodes that may be the diff_drive_controller (base at row 9, second at row");
  refused(replaced(controller, "0.24 ", "\"0.24\""), {}, ":11: '0.24' is no plain number");
  refused(replaced(controller, "0.0, 0.0, 0.01]", "0.0]"), {}, "must be a list of 6 numbers");
  refused(replaced(controller, "wheel_radius: 0.036", "wheel_separation: 0.3"), {},
          ":12: wheel_separation is there twice");
  refused(replaced(controller, "    linear:\n      x:\n        max_velocity: 1.0\n", "    linear: {x: {}}\n"),
          {}, "holds no keys yet");
  refused(replaced(controller, "[\"left\"]", "[\"left\""), {}, "is broken YAML");
  refused(replaced(controller, "my robot", "my \xff"), {}, "is not UTF-8");
}

TEST_CASE("With several controllers the one that is named is patched alone") {
  const std::string second = replaced(controller.substr(controller.find("base:\n")), "base", "second");
  const PatchCase patched("ros2_patch_named", with_drift(), controller + "\n" + second);
  auto options = radius;
  options.insert(options.end(), {"--within", "base"});
  const auto outcome = patched.run("ros2_control", options);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(patched.text(), ContainsSubstring(second));
}

// The intervals of a model as ranges to draw from.
#include "tools/wheelwright/export/ranges.hpp"

#include <yaml-cpp/yaml.h>

#include <map>

#include "tests/support/catch.hpp"
#include "tests/support/exported_model.hpp"
#include "tests/support/patch_case.hpp"

using namespace wheelwright;
using tools::ExitStatus;

namespace {

test::Outcome ranges(const RobotModel& model, const std::vector<std::string>& options) {
  const auto path = test::temporary_folder() / "ranges_test.yaml";
  config::save_model(model, path);
  std::vector<std::string> arguments{"export", path.string(), "--ranges"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return test::wheelwright_command(arguments);
}

std::map<std::string, YAML::Node> by_place(const std::string& text) {
  std::map<std::string, YAML::Node> places;
  for (const YAML::Node& row : YAML::Load(text)["parameters"])
    places[row["place"].as<std::string>()].reset(row);
  return places;
}

}  // namespace

TEST_CASE("Ranges give each number of a format its place, bounds and unit, as YAML") {
  RobotModel model = test::model_with_effects();
  const auto mujoco =
      ranges(model, {"--to", "mujoco", "--wheel-radius", "0.036", "--wheel-inertia", "0.002"});
  INFO(mujoco.err << mujoco.out);
  REQUIRE(mujoco.status == ExitStatus::done);
  const auto places = by_place(mujoco.out);
  const YAML::Node friction = places.at("joint left_wheel_joint frictionloss");
  CHECK_THAT(friction["lower"].as<double>() / friction["value"].as<double>(), WithinAbs(0.011 / 0.012, 1e-9));
  CHECK_THAT(friction["upper"].as<double>() / friction["value"].as<double>(), WithinAbs(0.014 / 0.012, 1e-9));
  CHECK(friction["unit"].as<std::string>() == "N m");
  CHECK(friction["from"].as<std::string>() == "coulomb_friction of 2026-02-03T00:00:00Z");
  const YAML::Node least = places.at("actuator right_wheel ctrlrange[0]");
  CHECK(least["lower"].as<double>() < least["value"].as<double>());
  CHECK(least["value"].as<double>() < least["upper"].as<double>());
  CHECK_THAT(mujoco.out, ContainsSubstring("# dead_zone: cannot be said in this format"));
}

TEST_CASE("Ranges for C name the wheel where an effect has a size for each") {
  RobotModel model = test::linear_model();
  test::add_effect(model, "dead_zone", "each_wheel", {0.03, 0.05, 1.0});
  const auto outcome = ranges(model, {"--to", "c"});
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  const auto places = by_place(outcome.out);
  CHECK(places.at("ww_effect_1[0]")["value"].as<double>() == 0.03);
  CHECK(places.at("ww_effect_2[0]")["value"].as<double>() == 0.05);
  CHECK_THAT(places.at("ww_effect_2[0]")["from"].as<std::string>(), ContainsSubstring("threshold_right"));
}

TEST_CASE("Ranges for C give the parameters of every effect at their places in the header") {
  const auto outcome = ranges(test::model_with_effects(), {"--to", "c"});
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  const auto places = by_place(outcome.out);
  CHECK(places.size() == 12);
  const YAML::Node track = places.at("ww_effect_1[0]");
  CHECK_THAT(track["lower"].as<double>(), WithinAbs(0.009, 1e-12));
  CHECK(track["unit"].as<std::string>() == "m");
}

TEST_CASE("A model without intervals gives ranges without rows, and every format gives some") {
  const auto empty = ranges(test::linear_model(), {"--to", "c"});
  CHECK(YAML::Load(empty.out)["parameters"].size() == 0);
  for (const std::string format : {"sdf", "ros2_control"}) {
    const auto outcome = ranges(test::model_with_effects(), {"--to", format, "--wheel-radius", "0.036"});
    INFO(outcome.err << outcome.out);
    CHECK(by_place(outcome.out).size() > 5);
  }
}

TEST_CASE("Options of a patch and of ranges that do not go together are refused in one line") {
  const auto refused = [](const std::vector<std::string>& options, const std::string& what) {
    const auto outcome = ranges(test::model_with_effects(), options);
    INFO(outcome.err);
    CHECK(outcome.status == ExitStatus::bad_input);
    CHECK(test::is_one_line(outcome.err));
    CHECK_THAT(outcome.err, ContainsSubstring(what));
  };
  refused({}, "add --to");
  refused({"--to", "c", "--patch", "a"}, "give one of them");
  refused({"--to", "sdf", "--left-joint", "a", "--wheel-radius", "1"}, "add --patch");
  refused({"--to", "sdf", "--without-delay", "--wheel-radius", "1"}, "they are MuJoCo's");
}

// A model in the formats of controllers and simulators.
#include "tools/wheelwright/export/model_export.hpp"

#include <yaml-cpp/yaml.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "config/load/model_file.hpp"
#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/exported_model.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/wheelwright_command.hpp"
#include "tools/wheelwright/export/drive_figures.hpp"
#include "tools/wheelwright/export/mujoco.hpp"
#include "tools/wheelwright/export/ros2_control.hpp"
#include "tools/wheelwright/export/sdf.hpp"

using namespace wheelwright;
using test::linear_model;
using test::wheelwright_command;
using tools::ExitStatus;
using tools::ModelText;

namespace {

constexpr double radius_m = 0.036;
constexpr double inertia_kg_m2 = 0.002;

AddedEffect anyhow(const EffectInfo& info, const EffectVariant& variant) {
  AddedEffect effect;
  effect.setting = {info.name, variant.name, {}};
  for (const auto& parameter : parameters_of(effect.setting)) {
    effect.setting.parameters.push_back(parameter.lower + 0.3 * (parameter.upper - parameter.lower));
  }
  return effect;
}

std::vector<ModelText> in_every_format(const RobotModel& model) {
  return {tools::to_ros2_control(model, radius_m), tools::to_sdf(model, {radius_m, {}}),
          tools::to_sdf(model, {radius_m, inertia_kg_m2}),
          tools::to_mujoco(model, {radius_m, inertia_kg_m2})};
}

boost::property_tree::ptree parse_xml(const std::string& fragment) {
  std::istringstream whole("<root>" + fragment + "</root>");
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(whole, tree, boost::property_tree::xml_parser::no_comments);
  return tree.get_child("root");
}

// XML has no "--" in comments, which that parser lets pass.
bool comments_are_sound(const std::string& text) {
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at)) {
    at = text.find("--", at + 4);
    if (at == std::string::npos || text[at + 2] != '>') return false;
  }
  return true;
}

double second_of_three(const std::string& numbers, int which) {
  std::istringstream in(numbers);
  double value = 0.0;
  for (int i = 0; i <= which; ++i) in >> value;
  return value;
}

std::string saved(const RobotModel& model) {
  const auto path = test::temporary_folder() / "model_export_test.yaml";
  config::save_model(model, path);
  return path.string();
}

}  // namespace

TEST_CASE(
    "Every effect of the library is put into each format, or said to have no place there, with the reason") {
  for (const auto& info : effect_library()) {
    for (const auto& variant : info.variants) {
      RobotModel model = linear_model();
      model.effects = {anyhow(info, variant)};
      for (const auto& [text, unsaid] : in_every_format(model)) {
        INFO(info.name << "\n" << text);
        CHECK(text.find(info.name) != std::string::npos);
        CHECK(text.find("nobody has found a place") == std::string::npos);
        CHECK((text.find("cannot be said") != std::string::npos) == !unsaid.empty());
      }
    }
  }
}

TEST_CASE(
    "ros2_control and Nav2 get their parameters as numbers that YAML reads, each with interval and date") {
  const std::string text = tools::to_ros2_control(test::model_with_effects(), radius_m).text;
  INFO(text);
  const YAML::Node both = YAML::Load(text);
  const YAML::Node drive = both["diff_drive_controller"]["ros__parameters"];
  CHECK_THAT(drive["wheel_separation"].as<double>(), WithinAbs(0.25, 1e-9));
  CHECK_THAT(drive["wheel_radius"].as<double>(), WithinAbs(radius_m, 1e-8));
  CHECK_THAT(drive["wheel_separation_multiplier"].as<double>(), WithinAbs(0.26 / 0.25, 1e-8));
  CHECK_THAT(drive["left_wheel_radius_multiplier"].as<double>(), WithinAbs(1.02 * 0.96, 1e-8));
  CHECK_THAT(drive["right_wheel_radius_multiplier"].as<double>(), WithinAbs(1.02, 1e-8));
  CHECK(drive["linear"]["x"]["has_velocity_limits"].as<bool>());
  CHECK_THAT(drive["linear"]["x"]["max_velocity"].as<double>(), WithinAbs(0.4, 1e-8));
  CHECK_THAT(drive["linear"]["x"]["min_acceleration"].as<double>(), WithinAbs(-0.8, 1e-8));
  CHECK_THAT(drive["angular"]["z"]["max_velocity"].as<double>(), WithinAbs(0.8 / 0.26, 1e-8));
  const YAML::Node smoother = both["velocity_smoother"]["ros__parameters"];
  CHECK_THAT(smoother["deadband_velocity"][0].as<double>(), WithinAbs(0.03, 1e-8));
  CHECK(smoother["deadband_velocity"].size() == 3);
  CHECK_THAT(smoother["max_decel"][0].as<double>(), WithinAbs(-0.8, 1e-8));
  CHECK(text.find("wheel_separation_multiplier: 1.04  # wheelwright: 95 % interval 1.036 to 1.048; "
                  "effective_track of "
                  "2026-02-03T00:00:00Z\n") != std::string::npos);
}

TEST_CASE("Friction that a controller makes up for is no dead band and no friction of a joint, and said so") {
  RobotModel model = linear_model();
  test::add_effect(model, "coulomb_friction", "controlled", {0.05, 0.03, 0.2});
  const tools::DriveFigures figures = tools::drive_figures(model);
  CHECK_FALSE(figures.smallest_command_m_s);
  CHECK_FALSE(figures.left_limits.friction_loss_m_s);
  const auto [text, unsaid] = tools::to_ros2_control(model, radius_m);
  REQUIRE(unsaid.size() == 1);
  CHECK_THAT(unsaid.front().reason, ContainsSubstring("controller of the wheels' speed makes up for it"));
}

TEST_CASE("Sizes of each wheel go to each joint, and of what is one number for both the tighter limit") {
  RobotModel model = linear_model();
  test::add_effect(model, "coulomb_friction", "each_wheel", {0.012, 0.03, 0.1});
  test::add_effect(model, "saturation", "speed_each_wheel", {0.4, 0.3, 0.0, 0.0});
  const tools::DriveFigures figures = tools::drive_figures(model);
  REQUIRE(figures.left_limits.friction_loss_m_s);
  REQUIRE(figures.right_limits.friction_loss_m_s);
  CHECK(figures.left_limits.friction_loss_m_s->value == 0.012);
  CHECK(figures.right_limits.friction_loss_m_s->value == 0.03);
  CHECK_THAT(figures.right_limits.friction_loss_m_s->interval->upper, WithinAbs(0.032, 1e-12));
  CHECK(figures.left_limits.largest_speed_m_s->value == 0.4);
  REQUIRE(figures.largest_speed_m_s);
  CHECK(figures.largest_speed_m_s->value == 0.3);
  const double gain = 0.5 * (figures.gain.left + figures.gain.right);
  CHECK_THAT(figures.smallest_command_m_s->value, WithinAbs(0.03 / gain, 1e-12));
}

TEST_CASE(
    "Counts that were scaled by turning on a wrong wheel base scale the wheels and their distance alike") {
  RobotModel model = linear_model();
  test::add_effect(model, "distance_scale", "turns_as_counted", {0.03});
  const tools::DriveFigures figures = tools::drive_figures(model);
  CHECK_THAT(figures.left_radius_multiplier.value, WithinAbs(1.03, 1e-12));
  CHECK_THAT(figures.right_radius_multiplier.value, WithinAbs(1.03, 1e-12));
  CHECK_THAT(figures.separation_multiplier.value, WithinAbs(1.03, 1e-12));
}

TEST_CASE(
    "What was measured of a wheel's drift becomes the covariance of odometry, and without it there is none") {
  RobotModel model = linear_model();
  CHECK_FALSE(YAML::Load(tools::to_ros2_control(model, radius_m)
                             .text)["diff_drive_controller"]["ros__parameters"]["pose_covariance_diagonal"]);
  model.left_fit = model.right_fit = WheelFit{};
  model.left_fit->drift_m_per_sqrt_s = 0.003;
  model.right_fit->drift_m_per_sqrt_s = 0.004;
  const auto diagonal =
      YAML::Load(tools::to_ros2_control(model, radius_m)
                     .text)["diff_drive_controller"]["ros__parameters"]["pose_covariance_diagonal"];
  REQUIRE(diagonal.size() == 6);
  CHECK_THAT(diagonal[0].as<double>(), WithinAbs(25e-6 / 4.0, 1e-13));
  CHECK_THAT(diagonal[5].as<double>(), WithinAbs(25e-6 / 0.0625, 1e-8));
}

TEST_CASE("Gazebo's plugin gets the geometry and limits of the model, in sound XML") {
  const std::string text = tools::to_sdf(test::model_with_effects(), {radius_m, inertia_kg_m2}).text;
  INFO(text);
  CHECK(comments_are_sound(text));
  const auto tree = parse_xml(text);
  const auto& plugin = tree.get_child("plugin");
  CHECK(plugin.get<std::string>("<xmlattr>.filename") == "gz-sim-diff-drive-system");
  // Of a robot in Gazebo whose wheels are as large and stand as far apart as given.
  const double separation_m = plugin.get<double>("wheel_separation");
  const double plugin_radius_m = plugin.get<double>("wheel_radius");
  const double wheel_rad_s = 0.5 * separation_m / plugin_radius_m;  // the plugin's, at a turn of 1 rad/s
  const double goes_further = 0.5 * 1.02 * 1.96;
  CHECK_THAT(2.0 * wheel_rad_s * radius_m / 0.25, WithinAbs(goes_further * 0.25 / 0.26, 1e-8));
  CHECK_THAT(radius_m / plugin_radius_m, WithinAbs(goes_further, 1e-8));
  CHECK_THAT(plugin.get<double>("max_linear_velocity"), WithinAbs(0.4, 1e-8));
  CHECK_THAT(plugin.get<double>("min_angular_acceleration"), WithinAbs(-1.6 / 0.25, 1e-8));
  CHECK(tree.count("dynamics") == 2);
  const auto& dynamics = tree.get_child("dynamics");
  CHECK_THAT(dynamics.get<double>("friction") / dynamics.get<double>("damping") * radius_m,
             WithinAbs(0.012, 1e-8));
  CHECK(tools::to_sdf(test::model_with_effects(), {radius_m, {}})
            .text.find("export it with the inertia of a wheel") != std::string::npos);
}

TEST_CASE("MuJoCo's actuator settles where the model does, friction and all") {
  const std::string text = tools::to_mujoco(test::model_with_effects(), {radius_m, inertia_kg_m2}).text;
  INFO(text);
  CHECK(comments_are_sound(text));
  const auto tree = parse_xml(text);
  REQUIRE(tree.count("joint") == 2);
  const auto& left = tree.get_child("actuator.general.<xmlattr>");
  const double damping = -second_of_three(left.get<std::string>("biasprm"), 2);
  const double friction = tree.get_child("joint.<xmlattr>").get<double>("frictionloss");
  const double command_m_s = 0.2;
  const double torque = left.get<double>("gainprm") * command_m_s / radius_m - friction;
  CHECK_THAT(torque / damping * radius_m, WithinAbs(0.9 * command_m_s - 0.012, 1e-8));
  // One period and four of the pole at 0.8 are its mean delay, of which the pole's time constant is lag.
  // The wheel is smaller than given, and with it what its motor speeds up.
  const double lag_s = inertia_kg_m2 * std::pow(1.02 * 0.96, 2) / damping;
  CHECK_THAT(lag_s, WithinAbs(-0.018 / std::log(0.8), 0.001));
  CHECK_THAT(left.get<double>("delay") - 0.001 + lag_s, WithinAbs(5.0 * 0.018, 1e-6));
  CHECK(left.get<double>("nsample") * 0.002 >= left.get<double>("delay"));
  CHECK_THAT(second_of_three(left.get<std::string>("ctrlrange"), 1) * 0.9 * radius_m, WithinAbs(0.4, 1e-8));
}

TEST_CASE("An actuator of a MuJoCo that knows no delay gets it as lag, and is told what it lacks") {
  RobotModel model = linear_model();
  test::add_effect(model, "transport_delay", "", {0.05});
  const auto delay_of = [](const ModelText& text) {
    return parse_xml(text.text).get_child("actuator.general.<xmlattr>").get_optional<double>("delay");
  };
  const tools::WheelGeometry wheel{radius_m, inertia_kg_m2};
  CHECK(delay_of(tools::to_mujoco(model, wheel)).value_or(0.0) > 0.05);
  tools::MujocoTarget before_3_5;
  before_3_5.knows_delay = false;
  const ModelText older = tools::to_mujoco(model, wheel, before_3_5);
  CHECK_FALSE(delay_of(older));
  CHECK_THAT(older.text, ContainsSubstring("transport_delay: cannot be said in this format"));
}

TEST_CASE("Whoever exports a model without what its target needs is told so in one line") {
  const std::string model = saved(test::model_with_effects());
  const auto refused = [&](const std::vector<std::string>& options, const std::string& what) {
    std::vector<std::string> arguments{"export", model};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto outcome = wheelwright_command(arguments);
    INFO(outcome.err);
    CHECK(outcome.status == ExitStatus::bad_input);
    CHECK(test::is_one_line(outcome.err));
    CHECK(outcome.err.find(what) != std::string::npos);
  };
  refused({"--to", "sdf"}, "add --wheel-radius");
  refused({"--to", "ros2_control"}, "add --wheel-radius");
  refused({"--to", "mujoco", "--wheel-radius", "0.036"}, "add --wheel-inertia");
  refused({"--to", "c", "--wheel-radius", "0.036"}, "neither --wheel-radius");
  refused({"--to", "urdf"}, "but must be c, ros2_control, sdf or mujoco");
  refused({"--to", "c", "--csv", "a.csv"}, "one or the other");
  refused({"-o", "a.h"}, "add --to");
  refused({"--to", "c", "--json"}, "-o OUT");
  refused({"--to", "c", "-o", model}, "would replace an input");
}

TEST_CASE("An exported model replaces its former self, and no file of another kind") {
  const std::string model = saved(test::model_with_effects());
  const auto out = (test::temporary_folder() / "model_export_test.out").string();
  const std::vector<std::string> to_c{"export", model, "--to", "c", "-o", out};
  const std::vector<std::string> to_sdf{"export", model, "--to", "sdf", "--wheel-radius", "0.036", "-o", out};
  CHECK(wheelwright_command(to_c).status == ExitStatus::done);
  CHECK(wheelwright_command(to_c).status == ExitStatus::done);
  const auto refused = wheelwright_command(to_sdf);
  CHECK(refused.status == ExitStatus::bad_input);
  CHECK(refused.err.find("holds something else") != std::string::npos);
  std::filesystem::remove(out);
  const auto written = wheelwright_command(to_sdf);
  CHECK(written.status == ExitStatus::done);
  CHECK(written.out.find("dead_zone cannot be said in this format") != std::string::npos);
  CHECK(wheelwright_command(to_sdf).status == ExitStatus::done);
}

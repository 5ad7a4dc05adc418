// The header of `wheelwright export --to c`, compiled by the C compiler of this machine.
#include "tools/wheelwright/export/c/c_header.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "config/load/text_format.hpp"
#include "model/effects/library/effect_library.hpp"
#include "model/prediction/free_run.hpp"
#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/export/c/c_fragment.hpp"

using namespace wheelwright;

namespace {

constexpr double step_m_s = 0.04;  // of commands that act in steps

// Both wheels hear of both commands, and not alike.
LinearModel linear_part() {
  return {ModelType::arma,
          0.018,
          0.258,
          {{0.0, 0.15, 0.1}, {0.0, 0.01, 0.0}, {0.7, 0.05}},
          {{0.02, 0.15, 0.0}, {0.0, 0.0, -0.01}, {0.8}}};
}

// Strong, and where it is found.
EffectSetting strong(const EffectInfo& info, const EffectVariant& variant) {
  EffectSetting setting{info.name, variant.name, {}};
  for (const auto& parameter : parameters_of(setting)) {
    double value = parameter.lower + 0.3 * (parameter.upper - parameter.lower);
    if (!parameter.sizes.empty())
      value = parameter.scales_effect ? parameter.sizes.back() : parameter.sizes.front();
    const bool is_limit = parameter.lower > 0.0;
    if (parameter.name.ends_with("_left")) value *= is_limit ? 1.5 : 0.5;
    if (parameter.name == "step") value = step_m_s;
    if (parameter.name == "x") value = 0.4;
    if (parameter.name == "y") value = 0.1;
    if (parameter.name == "length" || parameter.name == "width") value = 0.5;
    setting.parameters.push_back(value);
  }
  return setting;
}

RobotModel model_of(const std::vector<EffectSetting>& settings) {
  RobotModel model;
  model.linear_part = linear_part();
  for (const auto& setting : settings) model.effects.push_back({setting, {}, {}, "", {}, {}});
  return model;
}

EffectSetting of_library(const std::string& name, const std::string& variant = "") {
  const EffectInfo& info = *find_effect(name);
  return strong(info, info.variants[variant_index(info, variant)]);
}

// Every effect and variant by itself, then some that act together.
std::vector<RobotModel> models() {
  std::vector<RobotModel> all{model_of({})};
  for (const auto& info : effect_library()) {
    for (const auto& variant : info.variants) all.push_back(model_of({strong(info, variant)}));
  }
  all.push_back(model_of({of_library("dead_zone"), of_library("transport_delay"),
                          of_library("coulomb_friction"), of_library("effective_track")}));
  all.push_back(
      model_of({of_library("voltage_sag"), of_library("saturation", "speed"), of_library("backlash"),
                of_library("wheel_scale_mismatch"), of_library("lever_arm")}));
  all.push_back(model_of({of_library("yaw_bias", "moving_at_wheels"), of_library("turn_scrub"),
                          of_library("distance_scale"), of_library("direction_gain", "each_wheel")}));
  all.push_back(model_of({of_library("surface_patch", "wheel_round"), of_library("surface_patch"),
                          of_library("caster_kick", "swivel"), of_library("stiction")}));
  all.push_back(
      model_of({of_library("asymmetric_response", "motor_coasting"), of_library("coulomb_friction"),
                of_library("caster_kick", "swivel_at_wheels"), of_library("floor_slope", "wheel")}));
  all.push_back(
      model_of({of_library("coulomb_friction"), of_library("asymmetric_response", "motor_coasting")}));
  all.push_back(model_of({of_library("turn_scrub", "creep_at_wheels"), of_library("wheel_scale_mismatch"),
                          of_library("distance_scale"), of_library("caster_kick", "swivel_at_wheels")}));
  return all;
}

std::string name_of(const RobotModel& model) {
  std::string name;
  for (const auto& effect : model.effects) name += effect.setting.name + " " + effect.setting.variant + "; ";
  return name;
}

// Forward, backward, standing, turning, in jumps and slowly.
WheelPair command_at(int k) {
  const double along = k % 500 < 80 ? 0.0 : k / 250 % 2 == 0 ? 0.22 : 0.17 * std::sin(0.01 * k);
  const double turn = k / 350 % 3 == 1 ? 0.06 * std::sin(0.005 * k) : 0.0;
  return {along - turn, along + turn};
}
double battery_at(int k) {
  return 16.0 - 0.002 * k;
}

constexpr int periods = 2000;
constexpr int settling_periods = 6000;

// Straight, backward, in a curve, on the spot, at rest, and by commands that are whole steps.
std::vector<Twist> wanted() {
  const DcGain left = dc_gain(linear_part().left);
  const DcGain right = dc_gain(linear_part().right);
  const WheelPair u{3.0 * step_m_s, 2.0 * step_m_s};
  const WheelPair speed{left.from_left * u.left + left.from_right * u.right,
                        right.from_left * u.left + right.from_right * u.right};
  return {{0.15, 0.0},
          {0.05, 0.0},
          {-0.1, 0.0},
          {0.1, 0.5},
          {0.0, 0.8},
          {0.0, 0.0},
          twist_of_wheels(speed, linear_part().wheel_base_m)};
}

struct Row {
  WheelPair wheel;
  WheelPair floor;
  Twist twist;
  Pose pose;
  Pose observed;
};

struct Settled {
  double reached;
  Twist twist;
};

struct Answer {
  std::vector<Row> rows;
  std::vector<Settled> settled;
};

constexpr const char* driver = R"c(#include <stdio.h>
#include "run.h"
void RUN(const double (*rows)[3], int count, const double (*wanted)[2], int wishes, int settling, FILE *out) {
  wheelwright_model m;
  int i, k;
  wheelwright_init(&m);
  for (i = 0; i < count; ++i) {
    ww_pose seen;
    m.around.battery_v = rows[i][2];
    wheelwright_step(&m, rows[i][0], rows[i][1]);
    seen = wheelwright_observed(&m);
    fprintf(out, "%.17g %.17g %.17g %.17g %.17g %.17g ", m.wheel_speed.left, m.wheel_speed.right,
            m.floor_speed.left, m.floor_speed.right, m.twist.v, m.twist.w);
    fprintf(out, "%.17g %.17g %.17g %.17g %.17g %.17g\n", m.around.pose.x, m.around.pose.y, m.around.pose.theta,
            seen.x, seen.y, seen.theta);
  }
  for (i = 0; i < wishes; ++i) {
    int reached = 0;
    wheelwright_init(&m);
    m.around.battery_v = rows[0][2];
    for (k = 0; k < settling; ++k) {
      double left, right;
      reached = wheelwright_commands_for(&m, wanted[i][0], wanted[i][1], &left, &right);
      wheelwright_step(&m, left, right);
    }
    fprintf(out, "%d %.17g %.17g\n", reached, m.twist.v, m.twist.w);
  }
}
)c";

std::string main_of(std::size_t count) {
  std::string text = "#include <stdio.h>\n#include \"run.h\"\n#include \"rows.h\"\nint main(void) {\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += "  run_" + std::to_string(i) + "(rows, " + std::to_string(periods) + ", wanted, " +
            std::to_string(wanted().size()) + ", " + std::to_string(settling_periods) + ", stdout);\n";
  }
  return text + "  return 0;\n}\n";
}

std::string rows_text() {
  std::ostringstream text;
  text << "static const double rows[][3] = {\n";
  for (int k = 0; k < periods; ++k) {
    const WheelPair command = command_at(k);
    text << "{" << config::plain_number(command.left) << ", " << config::plain_number(command.right) << ", "
         << config::plain_number(battery_at(k)) << "},\n";
  }
  text << "};\nstatic const double wanted[][2] = {\n";
  for (const Twist& twist : wanted())
    text << "{" << config::plain_number(twist.v_m_s) << ", " << config::plain_number(twist.w_rad_s) << "},\n";
  text << "};\n";
  return text.str();
}

bool has_c_compiler() {
  return std::system("cc --version > /dev/null 2>&1") == 0;
}

// What each model does in C; empty, after a warning, without a compiler.
std::vector<Answer> answers_in_c(const std::vector<RobotModel>& models) {
  const auto folder = test::temporary_folder() / "c_header_test";
  std::filesystem::create_directory(folder);
  std::string declarations;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string number = std::to_string(i);
    std::ofstream(folder / ("model_" + number + ".h")) << tools::to_c(models[i]).text;
    std::ofstream(folder / ("model_" + number + ".c"))
        << "#include \"model_" + number + ".h\"\n#define RUN run_" + number + "\n#include \"driver.h\"\n";
    declarations +=
        "void run_" + number +
        "(const double (*rows)[3], int count, const double (*wanted)[2], int wishes, int settling, FILE "
        "*out);\n";
  }
  std::ofstream(folder / "run.h") << declarations;
  std::ofstream(folder / "driver.h") << driver;
  std::ofstream(folder / "rows.h") << rows_text();
  std::ofstream(folder / "main.c") << main_of(models.size());
  const std::string there = "cd '" + folder.string() + "' && ";
  REQUIRE(std::system((there + "cc -std=c99 -Wall -Wextra -pedantic -Werror -O1 -o all *.c -lm").c_str()) ==
          0);
  REQUIRE(std::system((there + "./all > answers").c_str()) == 0);

  std::vector<Answer> answers(models.size());
  std::ifstream in(folder / "answers");
  for (auto& answer : answers) {
    answer.rows.resize(periods);
    for (auto& [wheel, floor, twist, pose, seen] : answer.rows) {
      in >> wheel.left >> wheel.right >> floor.left >> floor.right >> twist.v_m_s >> twist.w_rad_s >>
          pose.x_m >> pose.y_m >> pose.theta_rad >> seen.x_m >> seen.y_m >> seen.theta_rad;
    }
    answer.settled.resize(wanted().size());
    for (auto& settled : answer.settled)
      in >> settled.reached >> settled.twist.v_m_s >> settled.twist.w_rad_s;
  }
  REQUIRE(in);
  return answers;
}

double apart(const WheelPair& a, const WheelPair& b) {
  return std::max(std::abs(a.left - b.left), std::abs(a.right - b.right));
}
double apart(const Pose& a, const Pose& b) {
  return std::max({std::abs(a.x_m - b.x_m), std::abs(a.y_m - b.y_m), std::abs(a.theta_rad - b.theta_rad)});
}
double apart(const Twist& a, const Twist& b) {
  return std::max(std::abs(a.v_m_s - b.v_m_s), std::abs(a.w_rad_s - b.w_rad_s));
}

double largest_difference(const RobotModel& model, const std::vector<Row>& rows) {
  ModelSimulation simulation(model);
  double largest = 0.0;
  for (int k = 0; k < periods; ++k) {
    const auto& motion = simulation.step(command_at(k), battery_at(k));
    const Row& row = rows[static_cast<std::size_t>(k)];
    largest = std::max({largest, apart(motion.wheel_m_s, row.wheel), apart(motion.floor_m_s, row.floor),
                        apart(motion.twist, row.twist), apart(simulation.pose(), row.pose),
                        apart(simulation.observed_pose(), row.observed)});
  }
  return largest;
}

// Effects that the inverse leaves alone, as their files say.
bool is_left_alone(const RobotModel& model) {
  return std::ranges::any_of(model.effects, [](const AddedEffect& effect) {
    const auto* fragment = tools::find_c_fragment(effect.setting.name);
    return fragment->remark("Inverse:").starts_with("not undone");
  });
}

DriveLog log_of_commands() {
  DriveLog log;
  for (int k = 0; k <= periods; ++k) {
    DriveSample sample;
    sample.t_s = 0.018 * k;
    sample.command_m_s = command_at(k);
    sample.battery_v = battery_at(k);
    log.samples.push_back(sample);
  }
  return log;
}

}  // namespace

TEST_CASE("Every effect of the library is written in C, or says why it cannot be") {
  for (const auto& info : effect_library()) {
    INFO(info.name);
    const auto* fragment = tools::find_c_fragment(info.name);
    REQUIRE(fragment != nullptr);
    CHECK(fragment->text.starts_with("/* " + info.name + ": " + info.summary));
    const bool is_said = fragment->remark("Not said:").empty();
    CHECK(is_said != fragment->remark("Inverse:").empty());
    for (const auto& variant : info.variants) {
      const tools::ModelText exported = tools::to_c(model_of({strong(info, variant)}));
      CHECK(exported.unsaid.empty() == is_said);
      CHECK(exported.text.find(info.name) != std::string::npos);
    }
  }
  CHECK(tools::c_fragments().size() == effect_library().size());
}

TEST_CASE("In C a model moves as it is simulated, and its inverse says what makes it move as told") {
  if (!has_c_compiler()) {
    WARN("skipped: there is no C compiler 'cc'");
    return;
  }
  const auto all = models();
  const auto answers = answers_in_c(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(name_of(all[i]));
    CHECK(largest_difference(all[i], answers[i].rows) < 1e-9);
    if (is_left_alone(all[i])) continue;
    std::size_t reached = 0;
    for (std::size_t k = 0; k < wanted().size(); ++k) {
      const Settled& settled = answers[i].settled[k];
      INFO("v " << wanted()[k].v_m_s << ", w " << wanted()[k].w_rad_s << ": v " << settled.twist.v_m_s
                << ", w " << settled.twist.w_rad_s);
      if (settled.reached == 0.0) continue;
      ++reached;
      CHECK(apart(settled.twist, wanted()[k]) < 1e-6);
    }
    CHECK(reached > 1);  // not rest alone
  }

  const RobotModel& together = all.back();
  const auto simulated = free_run(together, log_of_commands());
  REQUIRE(simulated.size() == periods + 1);
  for (std::size_t k = 0; k < periods; ++k) {
    const Row& row = answers.back().rows[k];
    REQUIRE(apart(simulated[k + 1].pose, row.observed) < 1e-9);
    REQUIRE(apart(simulated[k + 1].speed_m_s, row.floor) < 1e-9);
  }
}

TEST_CASE("The inverse of a sharp dead zone aims no command into its edge, and says what it leaves out") {
  if (!has_c_compiler()) {
    WARN("skipped: there is no C compiler 'cc'");
    return;
  }
  constexpr double threshold_m_s = 0.1;
  const auto answers = answers_in_c({model_of({{"dead_zone", "", {threshold_m_s, 0.002}}})});
  const auto& settled = answers.front().settled;  // in the order of wanted()
  const Settled& above = settled[0];
  const Settled& half = settled[1];
  const Settled& rest = settled[5];
  CHECK(above.reached == 1.0);
  CHECK(rest.reached == 1.0);
  CHECK(half.reached == 0.0);
  CHECK((half.twist.v_m_s == 0.0 || half.twist.v_m_s > 0.8 * threshold_m_s));
}

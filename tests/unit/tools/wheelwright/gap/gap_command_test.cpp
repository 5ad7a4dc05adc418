// wheelwright gap from the command line, on short runs of a robot that shares no formula with the library.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/common/command_line.hpp"

using namespace wheelwright;
using tools::ExitStatus;
namespace fs = std::filesystem;

namespace {

struct Outcome {
  ExitStatus status;
  std::string out;
  std::string err;
};

Outcome command(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const ExitStatus status = tools::run_command_line(arguments, {out, err});
  return {status, out.str(), err.str()};
}

std::vector<DriveLog> runs_with(const std::string& effect, test::Program program = test::Program::mixed,
                                double seconds = 24.0) {
  test::GapCaseSpec spec;
  spec.name = effect;
  spec.severity = test::Severity::large;
  spec.program = program;
  spec.runs = 2;
  spec.seconds = seconds;
  return test::make_gap_case(spec).runs;
}

// A folder of its own for each test, with run1.csv, run2.csv ... in it.
struct Workspace {
  fs::path folder;
  std::vector<std::string> files;
  fs::path output() const { return folder / "out"; }
};

Workspace workspace(const std::string& name, const std::vector<DriveLog>& runs) {
  Workspace made{test::temporary_folder() / name, {}};
  fs::create_directories(made.folder);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    made.files.push_back((made.folder / ("run" + std::to_string(i + 1) + ".csv")).string());
    config::save_drive_log(runs[i], made.files.back());
  }
  return made;
}

Outcome gap(const Workspace& at) {
  std::vector<std::string> arguments{"gap", "--train"};
  arguments.insert(arguments.end(), at.files.begin(), at.files.end());
  arguments.insert(arguments.end(), {"-o", at.output().string()});
  return command(arguments);
}

nlohmann::json gap_json(const Workspace& at) {
  return nlohmann::json::parse(std::ifstream(at.output() / "gap.json"));
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

double distance_error_m(const fs::path& model, const std::string& log) {
  const auto outcome = command({"score", model.string(), log, "--json"});
  REQUIRE(outcome.status == ExitStatus::done);
  return nlohmann::json::parse(outcome.out)["distance_rms_m"];
}

void check_refused(const Outcome& outcome, const std::string& where, const std::string& reason) {
  CHECK(outcome.status == ExitStatus::bad_input);
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK_THAT(outcome.err, ContainsSubstring(where));
  CHECK_THAT(outcome.err, ContainsSubstring(reason));
}

}  // namespace

TEST_CASE("wheelwright gap names a dead zone, adds it, and the model with it scores better than before") {
  const auto at = workspace("gap_dead_zone", runs_with("dead_zone"));
  const auto outcome = gap(at);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(outcome.out, ContainsSubstring("named: Missing: dead_zone."));

  const auto json = gap_json(at);
  CHECK(json["verdict"] == "named");
  REQUIRE(json["added"].size() == 1);
  const auto& added = json["added"][0];
  CHECK(added["effect"] == "dead_zone");
  const auto& threshold = added["parameters"]["threshold"];
  CHECK(threshold["unit"] == "m/s");
  CHECK(threshold["ci95"][0] < threshold["value"]);
  CHECK(threshold["ci95"][1] > threshold["value"]);
  CHECK(added["evidence"]["heldout_gain_nats"] > 9.0);
  CHECK(added["evidence"]["p_value"] < 0.001);
  CHECK(added["evidence"]["posterior"] > 0.9);
  for (const char* runs : {"train", "test"}) {
    const auto& position = json["gap"]["position_rms_m"][runs];
    CHECK(position["after"] < position["before"]);
  }

  const auto model = config::load_model(at.output() / "model.yaml");
  REQUIRE(model.effects.size() == 1);
  CHECK(model.effects.front().setting.name == "dead_zone");
  auto linear = model;
  linear.effects.clear();
  config::save_model(linear, at.folder / "linear.yaml");
  CHECK(distance_error_m(at.output() / "model.yaml", at.files[1]) <
        0.5 * distance_error_m(at.folder / "linear.yaml", at.files[1]));
}

TEST_CASE("gap.json has every key of its contract whatever the verdict") {
  auto swapped = runs_with("clean");
  for (auto& run : swapped) {
    for (auto& sample : run.samples) std::swap(sample.ticks->left, sample.ticks->right);
  }
  for (const auto& [name, runs] :
       {std::pair{"gap_keys_clean", runs_with("clean")}, std::pair{"gap_keys_swapped", swapped}}) {
    const auto at = workspace(name, runs);
    REQUIRE(gap(at).status == ExitStatus::done);
    const auto json = gap_json(at);
    for (const char* key : {"verdict", "added", "where", "gap", "not_testable", "detectable", "data_faults",
                            "next_experiment"}) {
      INFO(name << ": " << key);
      CHECK(json.contains(key));
    }
  }
}

TEST_CASE("Of a linear robot wheelwright gap says that nothing is missing, and what would have shown") {
  const auto at = workspace("gap_clean", runs_with("clean"));
  const auto outcome = gap(at);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(outcome.out, ContainsSubstring("runs: training: run1.csv; held out: run2.csv\n"));
  const auto json = gap_json(at);
  INFO(json["summary"].get<std::string>());
  CHECK(json["verdict"] == "nothing_missing");
  CHECK(json["check"]["passed"] == true);
  CHECK(json["data"]["untouched"] == false);
  CHECK(json["linear_changes"].empty());
  CHECK(json["added"].empty());
  REQUIRE_FALSE(json["detectable"].empty());
  CHECK(json["detectable"][0]["size"] > 0.0);
  CHECK(json["detectable"][0].contains("unit"));
}

TEST_CASE("Swapped sides and a wrong sign are faults of the data, and no effect is named behind them") {
  auto swapped = runs_with("dead_zone");
  auto turned = swapped;
  for (auto& run : swapped) {
    for (auto& sample : run.samples) std::swap(sample.ticks->left, sample.ticks->right);
  }
  for (auto& run : turned) {
    for (auto& sample : run.samples) sample.ticks->left = -sample.ticks->left;
  }
  for (const auto& [name, runs] : {std::pair{"gap_swapped", swapped}, std::pair{"gap_turned", turned}}) {
    const auto at = workspace(name, runs);
    fs::create_directories(at.output());
    std::ofstream(at.output() / "gap.json") << R"({"summary": "of an analysis before", "verdict": "named"})";
    std::ofstream(at.output() / "model.yaml") << "of an analysis before";
    REQUIRE(gap(at).status == ExitStatus::done);
    const auto json = gap_json(at);
    INFO(name);
    CHECK_FALSE(fs::exists(at.output() / "model.yaml"));
    CHECK(json["verdict"] == "bad_data");
    CHECK(json["added"].empty());
    CHECK(json["next_experiment"].is_null());
    REQUIRE_FALSE(json["data_faults"].empty());
    CHECK_THAT(json["data_faults"][0]["log"].get<std::string>(), ContainsSubstring("run1.csv"));
    CHECK_THAT(text_of(at.output() / "report.html"), ContainsSubstring("Faults of the data"));
  }
}

TEST_CASE("Logs that do not belong together, or are too short, are refused with file and line") {
  const auto good = runs_with("clean", test::Program::mixed, 8.0);
  auto other_period = good;
  other_period[1] = [] {
    test::GapCaseSpec spec;
    spec.runs = 1;
    spec.seconds = 8.0;
    spec.period_s = 0.054;
    return test::make_gap_case(spec).runs.front();
  }();
  check_refused(gap(workspace("gap_period", other_period)), "run2.csv:", "period");

  auto other_base = good;
  other_base[1].wheel_base_m += 0.01;
  check_refused(gap(workspace("gap_wheel_base", other_base)), "run2.csv:", "wheel base");

  auto without_counts = good;
  without_counts[1].metres_per_tick.reset();
  for (auto& sample : without_counts[1].samples) sample.ticks.reset();
  check_refused(gap(workspace("gap_columns", without_counts)), "run2.csv:", "encoder counts");

  auto brief = good;
  brief[0].samples.resize(10);
  check_refused(gap(workspace("gap_brief", brief)), "run1.csv:", "at least 20");
  brief = good;
  for (auto& run : brief) run.samples.resize(30);
  check_refused(gap(workspace("gap_all_brief", brief)), "run1.csv:", "s in all, but at least 5 s are needed");
  check_refused(gap(workspace("gap_single", {good[0]})), "run1.csv", "too short to hold a part of it out");
}

TEST_CASE("A run that is given twice is refused, since it would be held out from itself") {
  auto runs = runs_with("clean", test::Program::mixed, 8.0);
  runs.push_back(runs.front());
  const std::string last = "run" + std::to_string(runs.size()) + ".csv:";
  check_refused(gap(workspace("gap_twice", runs)), last, "the same run as");
}

TEST_CASE("The report stands alone, and shows what was found with its rivals and the search") {
  const auto at = workspace("gap_report", runs_with("dead_zone"));
  REQUIRE(gap(at).status == ExitStatus::done);
  const std::string page = text_of(at.output() / "report.html");
  for (const char* part : {"dead_zone", "95 % interval", "rival in its place", "The gap, before and after",
                           "The search", "Held-out runs, simulated", "prefers-color-scheme: dark"}) {
    CHECK_THAT(page, ContainsSubstring(part));
  }
  for (const char* link : {"src=", "<script", "@import", "url(http"}) {
    CHECK_THAT(page, !ContainsSubstring(link));
  }
  CHECK_THAT(page, !ContainsSubstring("rgb(1,2,3)"));  // ink of a picture that does not follow the page's
}

TEST_CASE("Runs without a reversal get a next experiment that has one, of commands alone, and no faster") {
  const auto runs = runs_with("clean", test::Program::forward_only);
  const auto at = workspace("gap_forward_only", runs);
  const auto outcome = gap(at);
  REQUIRE(outcome.status == ExitStatus::done);
  const auto next = gap_json(at)["next_experiment"];
  REQUIRE(next.is_object());
  CHECK(next["separates"].size() == 2);
  CHECK_THAT(outcome.out, ContainsSubstring("next: Drive "));

  const auto commands = config::load_drive_log(next["route_or_commands"].get<std::string>());
  CHECK_FALSE(commands.has_ticks());
  CHECK_THAT(commands.samples.back().t_s, WithinAbs(next["seconds"].get<double>(), 0.1));
  double least = 0.0;
  double largest = 0.0;
  for (const auto& sample : commands.samples) {
    least = std::min(least, sample.command_m_s.left);
    largest = std::max(largest, std::abs(sample.command_m_s.left));
  }
  CHECK(least < -0.02);
  CHECK(largest <= 0.3);
}

TEST_CASE("gap --simulation says of each effect what the simulation has and what the robot has") {
  test::GapCaseSpec spec;
  spec.runs = 2;
  spec.seconds = 24.0;
  spec.seed = 11;
  const auto simulated = workspace("gap_simulated", test::make_gap_case(spec).runs);
  spec.name = "dead_zone";
  spec.severity = test::Severity::large;
  const auto real = workspace("gap_real", test::make_gap_case(spec).runs);
  const Outcome outcome = command({"gap", "--simulation", simulated.files[0], simulated.files[1], "--train",
                                   real.files[0], real.files[1], "-o", real.output().string()});
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(outcome.out, ContainsSubstring("missing in the simulation"));
  const auto json = gap_json(real);
  CHECK(json["verdict"] == "named");
  CHECK(json["added"][0]["effect"] == "dead_zone");
  CHECK(json["simulation"]["check_passed"] == true);
  const auto& effect = json["simulation"]["effects"][0];
  CHECK(effect["kind"] == "missing");
  CHECK(effect["parameters"]["threshold"].contains("robot"));
  CHECK_FALSE(effect["parameters"]["threshold"].contains("simulation"));
  CHECK_THAT(text_of(real.output() / "report.html"), ContainsSubstring("Simulation and robot"));
}

TEST_CASE("gap --simulator runs the command on the commands of all runs, and says how far off it is") {
  test::GapCaseSpec spec;
  spec.runs = 2;
  spec.seconds = 24.0;
  spec.seed = 11;
  const auto real = workspace("gap_simulator", test::make_gap_case(spec).runs);
  // One that replays what the robot did: nothing is missing, and it is off by nothing.
  const Outcome outcome = command({"gap", "--simulator",
                                   "case {out} in *run1.csv) cp " + real.files[0] + " {out};; *) cp " +
                                       real.files[1] + " {out};; esac; test -s {commands}",
                                   "--train", real.files[0], real.files[1], "-o", real.output().string()});
  INFO(outcome.err);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(outcome.out, ContainsSubstring("simulator, "));
  const auto json = gap_json(real);
  CHECK(json["verdict"] == "nothing_missing");
  CHECK(json["simulation"]["gap"]["test"]["distance_rms_m"] < 1e-6);
  CHECK(fs::exists(real.output() / "simulation" / "run2_commands.csv"));
}

TEST_CASE(
    "A simulator that stops early, shows nothing any more, diverges or has other units is refused with the "
    "reason") {
  test::GapCaseSpec spec;
  spec.runs = 2;
  spec.seconds = 12.0;
  const auto real = workspace("gap_bad_simulator", test::make_gap_case(spec).runs);
  const auto said_of = [&](const std::string& awk) {
    const Outcome outcome = command(
        {"gap", "--simulator", "awk -F, -v OFS=, '" + awk + "' " + real.files[0] + " > {out}; : {commands}",
         "--train", real.files[0], real.files[1], "-o", real.output().string()});
    CHECK(outcome.status == ExitStatus::bad_input);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    return outcome.err;
  };
  CHECK_THAT(said_of("NR < 300"), ContainsSubstring("run1.csv: ends after 5."));
  CHECK_THAT(said_of("NR > 300 && !/^#/ { for (i = 4; i <= NF; ++i) $i = \"\" } { print }"),
             ContainsSubstring("neither poses nor counts after 5."));
  CHECK_THAT(said_of("NR > 300 && !/^#/ { $6 = 1e9 } { print }"),
             ContainsSubstring("the simulation diverges"));
  CHECK_THAT(said_of("!/^#|t,/ { $4 = $5 = \"\"; $6 = $7 = $8 = 0 } { print }"),
             ContainsSubstring("run1.csv: the robot stands still, but its commands are for "));
  CHECK_THAT(
      said_of(
          "!/^#|t,/ { $4 = $5 = \"\"; if (NR < 300) { x = $6; y = $7; a = $8 } else { $6 = x; $7 = y; $8 = a "
          "} } { print }"),
      ContainsSubstring("run1.csv: the robot stands still from 5."));
  CHECK_THAT(said_of("!/^#|t,/ { $4 = $5 = \"\"; if (NR > 300) $6 = $7 = \"\" } { print }"),
             ContainsSubstring("no numbers for x and y after 5."));
  for (const char* late_s : {"2", "1000"}) {
    CHECK_THAT(said_of("BEGIN { print \"t,x,y,theta\" } !/^#|t,/ && $6 != \"\" { print $1 + " +
                       std::string(late_s) + ", $6, $7, $8 }"),
               ContainsSubstring("s, the first command of 0 s; write the times of the commands"));
  }
  CHECK_THAT(said_of("!/^#|t,/ { $6 *= 1000; $7 *= 1000 } { print }"),
             ContainsSubstring("if its positions are in mm give --simulation-set reference.unit=mm"));
  CHECK_THAT(
      said_of("!/^#|t,/ { $4 = $5 = \"\"; $8 *= 57.2958 } { print }"),
      ContainsSubstring("if its headings are in degrees give --simulation-set reference.angle_unit=deg"));
}

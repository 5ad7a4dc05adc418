// wheelwright evaluate in its short form.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "config/load/route_file.hpp"
#include "config/load/simulation_config.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/common/command_line.hpp"
#include "tools/wheelwright/evaluation/attempts.hpp"

using namespace wheelwright;
using tools::ExitStatus;

namespace {

const std::string config_folder = WHEELWRIGHT_SOURCE_DIR "/config";

struct Outcome {
  ExitStatus status;
  std::string out;
  std::string err;
};

Outcome evaluate(std::vector<std::string> arguments) {
  std::ostringstream out;
  std::ostringstream err;
  arguments.insert(arguments.begin(), "evaluate");
  const ExitStatus status = tools::run_command_line(arguments, {out, err});
  return {status, out.str(), err.str()};
}

tools::EvaluationPlan plan_of(const std::string& robot) {
  tools::EvaluationPlan plan;
  plan.robot = config::load_simulation_config(config_folder + "/robots/" + robot + ".yaml");
  plan.route = config::load_route(config_folder + "/routes/paper_loop.yaml");
  return plan;
}

bool same_ends(const std::vector<tools::AttemptOutcome>& a, const std::vector<tools::AttemptOutcome>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t attempt = 0; attempt < a.size(); ++attempt) {
    for (std::size_t i = 0; i < a[attempt].size(); ++i) {
      const auto& drive = a[attempt].at(i);
      const auto& other_drive = b[attempt].at(i);
      if (drive.has_value() != other_drive.has_value()) return false;
      if (!drive) continue;
      const auto& one = drive->end;
      const auto& other = other_drive->end;
      if (one.has_value() != other.has_value()) return false;
      if (one && (one->x_m != other->x_m || one->y_m != other->y_m)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("The outcomes of an evaluation do not depend on the number of threads") {
  const auto plan = plan_of("table2");
  const auto alone = tools::run_attempts(plan, 2, 1);
  CHECK(same_ends(alone, tools::run_attempts(plan, 2, 2)));
}

TEST_CASE("Attempts of an evaluation are independent, and another seed gives others") {
  auto plan = plan_of("table2");
  const auto first = tools::run_attempt(plan, 0);
  CHECK_FALSE(same_ends({first}, {tools::run_attempt(plan, 1)}));
  plan.seed = 2;
  CHECK_FALSE(same_ends({first}, {tools::run_attempt(plan, 0)}));
}

TEST_CASE("Calibrated once, attempts differ only by their drives, and still do not depend on threads") {
  auto plan = plan_of("table2");
  plan.calibrated = tools::calibrate(plan, 0);
  const auto outcomes = tools::run_attempts(plan, 2, 2);
  CHECK(same_ends({outcomes[1]}, {tools::run_attempt(plan, 1)}));
  CHECK_FALSE(same_ends({outcomes[0]}, {outcomes[1]}));
}

TEST_CASE("On a robot without imperfections every candidate ends where it began") {
  auto plan = plan_of("perfect");
  plan.robot.room = config::load_room(config_folder + "/robots/rooms/box_without_slip.yaml");
  for (const auto& drive : tools::run_attempt(plan, 0)) {
    if (!drive) continue;  // by the gap workflow, which was not asked
    REQUIRE(drive->end);
    CHECK(std::hypot(drive->end->x_m, drive->end->y_m) < 0.04);
  }
}

TEST_CASE("With wheels drawn for each attempt robots miss by their odometry, each in a way of its own") {
  auto plan = plan_of("perfect");
  plan.robot.room = config::load_room(config_folder + "/robots/rooms/box_without_slip.yaml");
  plan.wheel_mismatch = 0.02;
  std::vector<double> offsets_m;
  for (const auto& outcome : tools::run_attempts(plan, 4, 2)) {
    REQUIRE(outcome.front()->end);
    offsets_m.push_back(std::hypot(outcome.front()->end->x_m, outcome.front()->end->y_m));
  }
  std::ranges::sort(offsets_m);
  CHECK(offsets_m.back() > 0.1);
  CHECK(offsets_m.back() > 2.0 * offsets_m.front());
}

TEST_CASE("evaluate --runs 2 prints a table, and end points with a picture where they are asked for") {
  const auto folder = test::temporary_folder() / "evaluate_output";
  const auto outcome = evaluate({"--runs", "2", "-o", folder.string()});
  CHECK(outcome.status == ExitStatus::done);
  CHECK_THAT(outcome.out, ContainsSubstring("ARMA, sensor-less"));
  CHECK(std::filesystem::exists(folder / "end_points.csv"));
  CHECK(std::filesystem::exists(folder / "end_points.gnuplot"));
}

TEST_CASE("evaluate --json gives every figure with its unit and interval") {
  const auto outcome = evaluate({"--runs", "3", "--json", "--seed", "3"});
  REQUIRE(outcome.status == ExitStatus::done);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["runs"] == 3);
  CHECK(json["seed"] == 3);
  const auto& fir = json["models"]["fir"];
  CHECK(fir["mean_offset"]["unit"] == "m");
  CHECK(fir["mean_offset"]["ci95"].size() == 2);
  CHECK(fir["published"]["mean_offset_m"] == 0.332);
  CHECK(fir["met"].is_boolean());
}

TEST_CASE("Only evaluate --check turns a row that is not met into exit status 1") {
  const std::string old_motors = config_folder + "/robots/old_motors.yaml";
  CHECK(evaluate({"--runs", "2", "--robot", old_motors}).status == ExitStatus::done);
  CHECK(evaluate({"--runs", "2", "--robot", old_motors, "--check"}).status == ExitStatus::answer_is_no);
}

TEST_CASE("evaluate shows a calibration for each attempt beside one calibration for all") {
  const auto both = evaluate({"--runs", "3", "--json"});
  REQUIRE(both.status == ExitStatus::done);
  const auto once = evaluate({"--runs", "3", "--json", "--calibrate", "once"});
  REQUIRE(once.status == ExitStatus::done);
  const auto json = nlohmann::json::parse(both.out);
  CHECK(json["one_calibration"] == nlohmann::json::parse(once.out)["models"]);
  CHECK(json["one_calibration"]["arma"] != json["models"]["arma"]);
  CHECK_THAT(evaluate({"--runs", "2"}).out, ContainsSubstring("one calibration [m]"));
  CHECK_THAT(evaluate({"--runs", "2", "--calibrate", "each"}).out, !ContainsSubstring("one calibration"));
}

TEST_CASE("The shipped calibration drives make models that agree better than those of the paper") {
  const auto models_of = [](const std::string& drives) {
    const auto outcome =
        evaluate({"--runs", "12", "--seed", "40", "--json", "--calibrate", "each", "--drives", drives});
    return nlohmann::json::parse(outcome.out)["models"];
  };
  const auto scatter_of = [](const nlohmann::json& models, const std::string& model) {
    return models[model]["standard_deviation"]["value"].get<double>();
  };
  const auto shipped = models_of("shipped");
  const auto paper = models_of("paper");
  for (const std::string model : {"fir", "arma"})
    CHECK(scatter_of(shipped, model) < 0.7 * scatter_of(paper, model));
}

TEST_CASE("Bad usage of evaluate is refused in one line") {
  const auto check = [](const Outcome& outcome, const std::string& reason) {
    CHECK(outcome.status == ExitStatus::bad_input);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_THAT(outcome.err, ContainsSubstring(reason));
  };
  check(evaluate({"--runs", "0"}), "--runs");
  check(evaluate({"--run", "3"}), "did you mean '--runs'");
  check(evaluate({"--calibrate", "twice"}), "--calibrate");
  check(evaluate({"--each"}), "--with-effects");
  check(evaluate({"--wheel-mismatch", "0.002"}), "--calibrate each");
  check(evaluate({"--wheel-mismatch", "0.002", "--calibrate", "each", "--with-effects"}), "--each");
  check(evaluate({"--robot", "absent.yaml"}), "absent.yaml");
  const auto open_route = test::temporary_folder() / "open_route.yaml";
  std::ofstream(open_route) << "name: open\ncheckpoints: [[1, 0], [1, 1]]\n";
  check(evaluate({"--route", open_route.string()}), "not closed; end it at [0, 0]");
}

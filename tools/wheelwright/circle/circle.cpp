// wheelwright circle: the whole circle on a simulated robot whose imperfections nobody was told.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>
#include <sstream>

#include "config/load/commands_file.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/route_file.hpp"
#include "config/load/shipped_folder.hpp"
#include "config/load/simulation_config.hpp"
#include "config/load/text_format.hpp"
#include "config/load/utc_now.hpp"
#include "tools/wheelwright/circle/circle_report.hpp"
#include "tools/wheelwright/circle/hidden_robot.hpp"
#include "tools/wheelwright/circle/own_imperfections.hpp"
#include "tools/wheelwright/common/command_line.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/evaluation/calibration_drives.hpp"
#include "tools/wheelwright/evaluation/learning_drives.hpp"
#include "tools/wheelwright/evaluation/prediction_error.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

struct CircleOptions {
  std::uint64_t seed = 1;
  std::size_t drives = 6;
  std::size_t laps = 5;
  std::string robot = config::shipped_folder() / "robots/perfect.yaml";
  std::string route = config::shipped_folder() / "routes/paper_loop.yaml";
  std::vector<std::string> hide;  // nothing: what chance picks
  std::string output;
  bool json = false;
};

// What chance decides after the robot is made: calibration, recorded drives, and laps do not share their
// luck.
enum class Purpose : std::uint64_t { calibrate = 1, learn, drive, experiment, prove };

constexpr std::size_t max_experiments = 2;
constexpr std::size_t proving_tours = 2;

class Circle {
 public:
  Circle(const CircleOptions& options, Streams streams)
      : options_(options), streams_(streams), folder_(options.output) {
    route_ = config::load_route(options.route);
    if (!is_closed(route_))
      throw UsageError(options.route +
                       ": the route is not closed; end it at [0, 0], so that start and end can be compared");
  }

  ExitStatus run() {
    hide();
    const RobotModel calibrated = calibrate();
    check_scale(calibrated);
    report_.before = laps(calibrated);
    record(calibrated);
    find_gap(calibrated);
    const RobotModel found = config::load_model(folder_ / "gap" / "model.yaml");
    report_.proof = prove(calibrated, found);
    const RobotModel& driven = report_.proof.is_better() ? found : calibrated;
    config::save_model(driven, folder_ / "driven.yaml");
    report_.after = laps(driven);
    print();
    return ExitStatus::done;
  }

 private:
  // A folder of its own: an empty one, or one that a circle filled before.
  void check_folder() const {
    std::error_code ignored;
    if (!fs::exists(folder_, ignored)) return;
    if (fs::is_directory(folder_, ignored) &&
        (fs::is_empty(folder_, ignored) || fs::exists(folder_ / "sealed" / "robot.yaml", ignored))) {
      return;
    }
    throw UsageError(folder_.string() + ": holds something else than a circle; give a folder of its own");
  }

  void hide() {
    check_folder();
    const fs::path sealed = folder_ / "sealed";
    make_folder(sealed);
    const HiddenRobot hidden =
        pick_hidden_robot(options_.seed, options_.hide, fs::absolute(options_.robot), "room.yaml");
    write(sealed / "room.yaml", hidden.room_yaml);
    write(sealed / "robot.yaml", hidden.robot_yaml);
    robot_ = config::load_simulation_config(sealed / "robot.yaml");
    report_.hidden = hidden.imperfections;
    report_.not_hidden = own_imperfections(config::load_simulation_config(options_.robot));
    report_.sealed_file = (sealed / "robot.yaml").string();
  }

  RobotTrial trial(Purpose purpose) const {
    const auto seed = simulation::Noise(options_.seed).bits() + static_cast<std::uint64_t>(purpose);
    return {robot_, RobotLimits{}, roomba::LinkConfig{}, simulation::Noise(seed)};
  }

  RobotModel calibrate() const {
    RobotTrial robot = trial(Purpose::calibrate);
    const CalibrationDrives drives = calibration_drives(Drives::shipped, route_.speed_m_s);
    MaybeModel model = robot.calibrate_response(drives.response);
    if (model) model = robot.calibrate_arma(*model, drives.random_drive);
    if (!model)
      throw DataRefusal("the hidden robot of seed " + std::to_string(options_.seed) + ": " + model.error());
    model->created = config::utc_now();
    model->robot = robot_.name;
    config::save_model(*model, folder_ / "calibrated.yaml");
    return *model;
  }

  // On a slope, or with tyres that scrub, turning in place gives a wrong scale.
  void check_scale(const RobotModel& calibrated) {
    if (!calibrated.encoder_scale) return;
    const double mean_diameter_m = 0.5 * (robot_.left.diameter_m + robot_.right.diameter_m);
    const double true_m = std::numbers::pi * mean_diameter_m / robot_.encoder.counts_per_revolution;
    const WheelPair& found_m = calibrated.encoder_scale->metres_per_tick;
    const auto error = scale_error(0.5 * (found_m.left + found_m.right), true_m);
    if (error) report_.not_hidden.push_back(*error);
  }

  // By both models with the same luck.
  Laps laps(const RobotModel& model) const {
    RobotTrial robot = trial(Purpose::drive);
    Laps laps;
    for (std::size_t i = 0; i < options_.laps; ++i) {
      const DriveOutcome outcome = robot.drive(route_, PoseSource::arma, model);
      if (outcome.end) {
        laps.offsets_m.push_back(std::hypot(outcome.end->x_m, outcome.end->y_m));
      } else {
        ++laps.stopped;
        laps.failure = outcome.failure;
      }
    }
    return laps;
  }

  void record(const RobotModel& model) {
    RobotTrial robot = trial(Purpose::learn);
    simulation::Noise chance(simulation::Noise(options_.seed).bits());
    const auto logs = learning_drives(options_.drives, robot, model, chance);
    if (!logs) throw DataRefusal("a recorded drive: " + logs.error());
    for (const DriveLog& log : *logs) keep(log, logs_.end());
  }

  void keep(const DriveLog& log, std::vector<std::string>::const_iterator place) {
    const fs::path path = folder_ / (log.name + ".csv");
    config::save_drive_log(log, path);
    logs_.insert(place, path.string());
  }

  Proof prove(const RobotModel& calibrated, const RobotModel& found) const {
    return {own_drives(calibrated), own_drives(found)};
  }

  // On the route and on tours at its speed, which the model has not seen and drives itself: where it steers,
  // the commands may be others than those it was learned from. All models with the same luck.
  OwnDrives own_drives(const RobotModel& model) const {
    RobotTrial robot = trial(Purpose::prove);
    simulation::Noise chance(simulation::Noise(options_.seed).bits() + 1);
    const ProofDrives drives = proof_drives(route_, proving_tours, robot, model, chance);
    return {position_error_m(model, drives.logs), drives.stopped, drives.failure};
  }

  // Where the workflow cannot decide, what it asks for is driven, and it is asked again.
  void find_gap(const RobotModel& model) {
    auto json = analyse();
    RobotTrial robot = trial(Purpose::experiment);
    for (std::size_t i = 1; i <= max_experiments; ++i) {
      const auto& next = json["next_experiment"];
      if (json["verdict"] != "ambiguous" || next.is_null()) break;
      if (!drive_experiment(robot, model, next, i)) break;
      json = analyse();
    }
    report_.verdict = json["verdict"];
    for (const auto& added : json["added"]) report_.named.push_back(added["effect"]);
  }

  // False where the robot did not come to its end.
  bool drive_experiment(RobotTrial& robot, const RobotModel& model, const nlohmann::json& next,
                        std::size_t number) {
    Mission mission;
    mission.commanded_drive = config::load_commands(next["route_or_commands"].get<std::string>(),
                                                    RobotLimits{}.largest_wheel_speed_m_s);
    auto log = robot.record(mission, model, {});
    report_.experiments.push_back(
        {next["manoeuvre"], next["seconds"], next["separates"], log ? "" : log.error()});
    if (!log) return false;
    log->name = "experiment_" + std::to_string(number);
    // First, since the last runs are held out.
    keep(*log, logs_.begin());
    return true;
  }

  nlohmann::json analyse() {
    const fs::path folder = folder_ / "gap";
    std::vector<std::string> arguments{"gap", "--train"};
    arguments.insert(arguments.end(), logs_.begin(), logs_.end());
    arguments.insert(arguments.end(),
                     {"--model", (folder_ / "calibrated.yaml").string(), "-o", folder.string()});
    std::ostringstream text;
    const ExitStatus status = run_command_line(arguments, {text, streams_.err});
    if (status != ExitStatus::done) throw DataRefusal("the gap workflow did not come to its end");
    write(folder / "gap.txt", text.str());
    return load_json(folder / "gap.json");
  }

  void print() const {
    if (!options_.json) return print_circle(streams_.out, report_);
    nlohmann::ordered_json json{{"seed", options_.seed}, {"laps", options_.laps}};
    json.update(circle_json(report_));
    streams_.out << json_text(json) << "\n";
  }

  const CircleOptions& options_;
  Streams streams_;
  fs::path folder_;
  Route route_;
  simulation::SimulationConfig robot_;
  std::vector<std::string> logs_;
  CircleReport report_;
};

}  // namespace

Action add_circle(CLI::App& app) {
  const auto options = std::make_shared<CircleOptions>();
  CLI::App* command =
      app.add_subcommand("circle", "Hide imperfections in a simulated robot, find them, drive better");
  command->add_option("--seed", options->seed, "Of the imperfections and all noise")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--robot", options->robot, "Simulated robot to hide them in")
      ->check(CLI::ExistingFile)
      ->capture_default_str();
  command->add_option("--hide", options->hide, "What to hide instead of what the seed picks")
      ->check(CLI::IsMember(imperfection_names()));
  command->add_option("--route", options->route, "Closed route")->capture_default_str();
  command->add_option("--drives", options->drives, "Drives of about a minute to learn from")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
  command->add_option("--laps", options->laps, "Drives of the route by each model")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "Folder for all results")->required();
  command->add_flag("--json", options->json, "As JSON");
  command->footer(
      "All on the virtual clock. Offsets are true distances from start to end of the route, driven by the\n"
      "model alone: A by the calibrated one, B by the one that was found if it predicts more drives of its\n"
      "own better.\n"
      "Example: wheelwright circle --seed 7 -o out/circle");
  return [options](Streams streams) { return Circle(*options, streams).run(); };
}

}  // namespace wheelwright::tools

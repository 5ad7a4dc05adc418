// wheelwright gap: finds where a simulation and measured runs disagree, names what is missing, adds it, and
// shows the gap shrink.
#include <array>
#include <filesystem>
#include <memory>
#include <ostream>

#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/text_format.hpp"
#include "config/load/utc_now.hpp"
#include "model/gap/analysis.hpp"
#include "model/gap/data_checks/informative_segments.hpp"
#include "model/gap/next_experiment/next_experiment.hpp"
#include "tools/option_checks.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/common/parallel_for.hpp"
#include "tools/wheelwright/common/progress_line.hpp"
#include "tools/wheelwright/gap/compare_simulation.hpp"
#include "tools/wheelwright/gap/gap_json.hpp"
#include "tools/wheelwright/gap/gap_text.hpp"
#include "tools/wheelwright/gap/report.hpp"
#include "tools/wheelwright/gap/simulation_section.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

namespace wheelwright::tools {
namespace {

struct GapCommand {
  std::vector<std::string> train;
  std::vector<std::string> test;
  SimulationInput simulation;
  ImportOptions import;
  std::string model;
  std::string output;
  std::optional<double> largest_speed_m_s;
  std::optional<double> largest_change_m_s;
  std::optional<double> radius_m;
};

// Of training runs; a third of it for test runs.
constexpr std::size_t max_rows = 60'000;

// As in "Used 18 min of 5.0 h: 18 segments that show the most."
std::string used_text(const gap::Segments& segments) {
  const auto text = [](double seconds) {
    return seconds < 7200.0 ? config::fixed_number(seconds / 60.0, 0) + " min"
                            : config::fixed_number(seconds / 3600.0, 1) + " h";
  };
  return "Used " + text(segments.used_s) + " of " + text(segments.given_s) + ": the " +
         std::to_string(segments.runs.size()) + " segments that show the most.";
}

// The folder is for the analysis alone: `replay` takes a model.yaml beside a run's log for the run's own.
void check_folder(const GapCommand& command) {
  constexpr std::array<std::string_view, 4> names{"gap.json", "model.yaml", "next_experiment.csv",
                                                  "report.html"};
  const std::filesystem::path folder = command.output;
  std::error_code ignored;
  if (std::filesystem::exists(folder / "drive_log.csv", ignored)) {
    throw UsageError(folder.string() + ": is the folder of a run; give the analysis a folder of its own");
  }
  config::InputFiles inputs{command.model, command.import.mapping};
  inputs.insert(inputs.end(), command.train.begin(), command.train.end());
  inputs.insert(inputs.end(), command.test.begin(), command.test.end());
  inputs.insert(inputs.end(), command.simulation.logs.begin(), command.simulation.logs.end());
  if (const auto problem =
          config::check_output_folder(folder, {"gap.json", config::OutputKind::gap}, names, inputs)) {
    throw UsageError(*problem);
  }
}

gap::ManoeuvreLimits limits_of(const GapCommand& command, const std::vector<DriveLog>& logs) {
  gap::ManoeuvreLimits limits = gap::limits_of(logs);
  limits.largest_speed_m_s = command.largest_speed_m_s.value_or(limits.largest_speed_m_s);
  limits.largest_change_m_s = command.largest_change_m_s.value_or(limits.largest_change_m_s);
  limits.radius_m = command.radius_m.value_or(limits.radius_m);
  return limits;
}

// A file of an analysis before this one is not to be taken for one of this.
void remove_old(const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}

// What the analysis leaves in its folder beside the report; says which files that are.
std::string write_files(const GapCommand& command, const gap::GapAnalysis& analysis,
                        const std::optional<gap::NextExperiment>& next,
                        const ComparedSimulation* simulation) {
  const std::filesystem::path folder = command.output;
  const auto next_file = std::filesystem::absolute(folder / "next_experiment.csv");
  const auto model_file = folder / "model.yaml";
  std::string written = "gap.json, ";
  write({folder / "gap.json", config::OutputKind::gap},
        gap_to_json(analysis, next, next_file.string(), simulation));
  if (!analysis.after.linear_part.left.from_left.empty()) {
    config::save_model(analysis.after, model_file);
    written += "model.yaml, ";
  } else {
    remove_old(model_file);
  }
  if (next) {
    config::save_drive_log(next->commands, next_file);
    written += "next_experiment.csv, ";
  } else {
    remove_old(next_file);
  }
  return written;
}

void stamp(RobotModel& model, const std::string& robot) {
  model.created = config::utc_now();
  model.robot = robot;
  for (auto& effect : model.effects) effect.created = model.created;
}

// What is more than an analysis can take in is left out before anything else is held in memory.
gap::Segments load_segments(const LogInput& input, std::size_t rows, std::ostream& err,
                            ProgressLine& progress) {
  if (input.paths.empty()) return {};
  return gap::informative_segments(load_all_runs(input, err, progress), {.max_rows = rows});
}

ExitStatus run_gap(const GapCommand& command, Streams streams) {
  check_folder(command);
  if (!command.simulation.simulator.command.empty()) check_simulator(command.simulation.simulator);
  gap::GapOptions options;
  if (!command.model.empty()) options.model = config::load_model(command.model);
  ProgressLine progress(streams.err);
  const auto say = progress.callback();
  const gap::Segments train_segments =
      load_segments({command.train, command.import, command.test}, max_rows, streams.err, progress);
  const gap::Segments test_segments =
      load_segments({command.test, command.import, command.train}, max_rows / 3, streams.err, progress);
  const std::vector<DriveLog>& train = train_segments.runs;
  const std::vector<DriveLog>& test = test_segments.runs;
  make_folder(command.output);
  std::optional<ComparedSimulation> simulation;
  if (command.simulation.any()) {
    const auto folder = std::filesystem::path(command.output) / "simulation";
    simulation = compare_simulation(command.simulation, train, test, folder, streams.err, progress);
  }
  tl::expected<gap::GapAnalysis, gap::GapRefusal> analysis =
      simulation ? simulation->gap.robot : gap::analyse_gap(train, test, options, parallel_for(), say);
  if (!analysis) throw UsageError(analysis.error().reason);
  for (const gap::Segments* segments : {&train_segments, &test_segments}) {
    if (!segments->all_used()) analysis->summary += " " + used_text(*segments);
  }
  say("next experiment", 0.95);
  const auto next = gap::next_experiment(*analysis, train, limits_of(command, train), parallel_for());
  stamp(analysis->after, robot_name(train.front()));

  const std::filesystem::path folder = command.output;
  say("report", 0.98);
  const std::string written = write_files(command, *analysis, next, simulation ? &*simulation : nullptr);
  write({folder / "report.html", config::OutputKind::page},
        gap_report(*analysis, train, test, next, simulation ? &*simulation : nullptr));
  progress.clear();
  print_gap(streams.out, *analysis);
  if (simulation) print_simulation(streams.out, *simulation);
  if (next) {
    streams.out << "\nnext: " << experiment_text(*next) << "\n"
                << "      wheelwrightd --config my_robot.yaml --commands "
                << (folder / "next_experiment.csv").string() << "\n";
  }
  streams.out << "\nwrote " << written << "report.html in " << folder.string() << "\n";
  return ExitStatus::done;
}

void add_simulation_options(CLI::App& command, CLI::Option& model, SimulationInput& input) {
  CLI::Option* logs = command.add_option("--simulation", input.logs,
                                         "Runs of your simulator, by any commands: what it lacks, what it "
                                         "has in another size, and what it has that the robot has not");
  CLI::Option* run = command.add_option("--simulator", input.simulator.command,
                                        "Your simulator, run on the commands of all runs: a command for the "
                                        "shell in which {commands} and {out} stand for files");
  logs->excludes(&model)->excludes(run);
  run->excludes(&model);
  command
      .add_option("--simulator-limit", input.simulator.limit_s,
                  "Time for one run of the simulator, s; default 120")
      ->needs(run)
      ->check(number_between(1.0, 86400.0, "s"));
  command.add_option("--simulation-mapping", input.import.mapping,
                     "Mapping file (YAML) for the simulator's logs");
  command.add_option("--simulation-set", input.import.settings, "Keys of that mapping")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

}  // namespace

Action add_gap(CLI::App& app) {
  const auto options = std::make_shared<GapCommand>();
  CLI::App* command =
      app.add_subcommand("gap", "What effect the simulation of a robot lacks, and how sure that is");
  command->add_option("--train", options->train, "Training logs")->required();
  command->add_option("--test", options->test,
                      "Drive logs to confirm it on; else some of the others are held out");
  CLI::Option* model = command->add_option("--model", options->model,
                                           "Model whose gap is looked for; else a linear one is fitted");
  add_simulation_options(*command, *model, options->simulation);
  add_import_options(*command, options->import);
  command->add_option("-o,--output", options->output, "Folder for gap.json, model.yaml and report.html")
      ->required();
  command
      ->add_option("--largest-speed", options->largest_speed_m_s,
                   "Largest wheel speed in the next experiment, m/s (default: that of the logs, 0.3 at most)")
      ->check(number_between(0.02, 2.0, "m/s"));
  command
      ->add_option("--largest-change", options->largest_change_m_s,
                   "Of a wheel's command at once in the next experiment, m/s; else that of the logs, or 0.15 "
                   "where they have none as hard")
      ->check(number_between(0.01, 2.0, "m/s"));
  command
      ->add_option("--free-radius", options->radius_m,
                   "Of the free floor around the start of the next experiment, m; else 1")
      ->check(number_between(0.3, 50.0, "m"));
  command->footer("Example: wheelwright gap --train run1.csv run2.csv run3.csv --test run4.csv -o gap");
  return [options](Streams streams) { return run_gap(*options, streams); };
}

}  // namespace wheelwright::tools

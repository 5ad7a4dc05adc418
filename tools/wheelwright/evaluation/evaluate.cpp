// wheelwright evaluate: the source paper's Table II on the simulated robot.
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <thread>

#include "config/load/output_file.hpp"
#include "config/load/route_file.hpp"
#include "config/load/shipped_folder.hpp"
#include "config/load/simulation_config.hpp"
#include "tools/option_checks.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/progress_line.hpp"
#include "tools/wheelwright/evaluation/attempts.hpp"
#include "tools/wheelwright/evaluation/end_point_plot.hpp"
#include "tools/wheelwright/evaluation/gap_models.hpp"
#include "tools/wheelwright/evaluation/offset_table.hpp"
#include "tools/wheelwright/page/gnuplot.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

struct EvaluateOptions {
  std::size_t runs = 30;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string robot = config::shipped_folder() / "robots/table2.yaml";
  std::string route = config::shipped_folder() / "routes/paper_loop.yaml";
  std::string output;
  Calibrate calibrate = Calibrate::each;
  bool json = false;
  bool check = false;
  bool with_effects = false;
};

void write(const fs::path& path, const std::string& text) {
  if (const auto error = config::write_output({path, config::OutputKind::any}, text))
    throw UsageError(*error);
}

void make_folder(const fs::path& folder, const EvaluateOptions& options) {
  constexpr std::array<std::string_view, 4> names{"evaluation.json", "end_points.csv", "end_points.gnuplot",
                                                  "end_points.svg"};
  if (const auto problem =
          config::check_output_folder(folder, {"evaluation.json", config::OutputKind::evaluation}, names,
                                      {options.robot, options.route})) {
    throw UsageError(*problem);
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw UsageError(folder.string() + ": cannot be made a folder: " + error.message());
}

void write_end_points(const fs::path& folder, const std::vector<AttemptOutcome>& outcomes, Streams streams) {
  write(folder / "end_points.csv", end_points_csv(outcomes));
  const fs::path script = folder / "end_points.gnuplot";
  write(script, end_points_script(outcomes, "end_points.csv", "end_points.svg"));
  const fs::path picture = folder / "end_points.svg";
  if (const auto problem = run_gnuplot(script)) {
    streams.err << "wheelwright: " << picture.string() << ": " << *problem << "\n";
  }
}

ExitStatus run_evaluate(const EvaluateOptions& options, Streams streams) {
  EvaluationPlan plan;
  plan.robot = config::load_simulation_config(options.robot);
  plan.route = config::load_route(options.route);
  plan.seed = options.seed;
  plan.calibrate = options.calibrate;
  if (!is_closed(plan.route))
    throw UsageError(options.route +
                     ": the route is not closed; end it at [0, 0], so that start and end can be compared");
  if (!options.output.empty()) make_folder(options.output, options);
  ProgressLine progress(streams.err);
  const auto say = progress.callback();
  std::string found;
  if (options.with_effects) {
    say("the gap workflow, once", 0.0);
    const auto learned = learn_gap_models(plan);
    if (!learned) throw DataRefusal("the gap workflow: " + learned.error());
    plan.gap = learned->models;
    found = learned->found;
  }
  const auto outcomes = run_attempts(plan, options.runs, options.threads, [&](std::size_t done) {
    say(std::to_string(done) + " of " + std::to_string(options.runs) + " attempts",
        static_cast<double>(done) / static_cast<double>(options.runs));
  });
  progress.clear();
  const auto rows = offset_rows(outcomes, options.seed);
  const nlohmann::ordered_json json{{"robot", plan.robot.name}, {"route", plan.route.name},
                                    {"runs", options.runs},     {"seed", options.seed},
                                    {"found", found},           {"models", offset_json(rows)}};
  if (!options.output.empty()) {
    write(fs::path(options.output) / "evaluation.json", json_text(json) + "\n");
    write_end_points(options.output, outcomes, streams);
  }
  if (options.json) {
    streams.out << json_text(json) << "\n";
  } else {
    streams.out << options.runs << " attempts per model on robot '" << plan.robot.name << "', route '"
                << plan.route.name << "', seed " << options.seed << "\n\n";
    print_offset_table(streams.out, rows);
    if (!found.empty()) streams.out << "\nthe gap workflow, once before all attempts: " << found << "\n";
  }
  return options.check && !all_met(rows) ? ExitStatus::answer_is_no : ExitStatus::done;
}

}  // namespace

Action add_evaluate(CLI::App& app) {
  const auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = app.add_subcommand("evaluate", "The source paper's Table II on the simulated robot");
  command->add_option("--runs", options->runs, "Attempts per model")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of starting errors and noise")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--robot", options->robot, "Simulated robot")->capture_default_str();
  command->add_option("--route", options->route, "Closed route")->capture_default_str();
  command->add_option("--calibrate", options->calibrate, "Before each attempt or once before all")
      ->transform(one_of<Calibrate>({{"each", Calibrate::each}, {"once", Calibrate::once}}))
      ->default_str("each");
  command->add_flag("--with-effects", options->with_effects,
                    "Run the gap workflow once, and drive with what it found as well");
  command->add_option("--threads", options->threads, "Threads; the result does not depend on them")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("-o,--output", options->output,
                      "Folder for end_points.csv, evaluation.json and a picture");
  command->add_flag("--json", options->json, "As JSON");
  command->add_flag("--check", options->check, "Exit status 1 where a published row is not met");
  command->footer(
      "Each attempt calibrates the robot and drives the route once with each model; the offset is the true\n"
      "distance from start to end. Brackets are 95 % intervals by bootstrap. A published row is met where "
      "the\n"
      "mean is within 30 % of it.\nExample: wheelwright evaluate --runs 30 -o out/evaluation");
  return [options](Streams streams) { return run_evaluate(*options, streams); };
}

}  // namespace wheelwright::tools

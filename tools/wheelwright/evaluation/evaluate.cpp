// wheelwright evaluate: the source paper's Table II on the simulated robot.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
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
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/common/parallel_for.hpp"
#include "tools/wheelwright/common/progress_line.hpp"
#include "tools/wheelwright/evaluation/attempts.hpp"
#include "tools/wheelwright/evaluation/end_point_plot.hpp"
#include "tools/wheelwright/evaluation/gap_models.hpp"
#include "tools/wheelwright/evaluation/offset_table.hpp"
#include "tools/wheelwright/page/gnuplot.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

enum class Calibrate { each, once, both };

struct EvaluateOptions {
  std::size_t runs = 30;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string robot = config::shipped_folder() / "robots/table2.yaml";
  std::string route = config::shipped_folder() / "routes/paper_loop.yaml";
  std::string output;
  Calibrate calibrate = Calibrate::both;
  Drives drives = Drives::shipped;
  bool json = false;
  bool check = false;
  bool with_effects = false;
  bool each = false;
  double wheel_mismatch = 0.0;
};

void make_output_folder(const fs::path& folder, const EvaluateOptions& options) {
  constexpr std::array<std::string_view, 4> names{"evaluation.json", "end_points.csv", "end_points.gnuplot",
                                                  "end_points.svg"};
  if (const auto problem =
          config::check_output_folder(folder, {"evaluation.json", config::OutputKind::evaluation}, names,
                                      {options.robot, options.route})) {
    throw UsageError(*problem);
  }
  make_folder(folder);
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

EvaluationPlan plan_of(const EvaluateOptions& options) {
  EvaluationPlan plan;
  plan.robot = config::load_simulation_config(options.robot);
  plan.route = config::load_route(options.route);
  plan.seed = options.seed;
  plan.drives = options.drives;
  plan.learn_each = options.with_effects && options.each;
  plan.wheel_mismatch = options.wheel_mismatch;
  if (!is_closed(plan.route))
    throw UsageError(options.route +
                     ": the route is not closed; end it at [0, 0], so that start and end can be compared");
  return plan;
}

// Verdict and names, in one line. The models go into the plan.
std::string learn_once(EvaluationPlan& plan) {
  const CalibratedModels calibrated = calibrate(plan, before_all_attempts);
  if (!calibrated.arma) throw DataRefusal("the calibration: " + calibrated.arma.error());
  const auto learned = learn_gap_models(plan, before_all_attempts, *calibrated.arma, parallel_for());
  if (!learned) throw DataRefusal("the gap workflow: " + learned.error());
  plan.gap = learned->models;
  return "once before all attempts: " + learned->found;
}

// How often each name was found.
std::string names_of(const std::vector<AttemptOutcome>& outcomes) {
  std::map<std::string, std::size_t> counts;
  for (const AttemptOutcome& outcome : outcomes) {
    const auto& drive = outcome.back();
    if (!drive) continue;
    if (drive->effects.empty()) ++counts[drive->has_model ? "nothing" : "failed"];
    for (const std::string& name : drive->effects) ++counts[name];
  }
  std::string text = "before each attempt:";
  for (const auto& [name, count] : counts) text += " " + name + " " + std::to_string(count);
  return text;
}

// The attempts once more, with the models of the first one's calibration. A gap workflow belongs to the
// attempts with a calibration each.
EvaluationPlan with_one_calibration(EvaluationPlan plan) {
  plan.calibrated = calibrate(plan, 0);
  plan.gap.reset();
  plan.learn_each = false;
  return plan;
}

void check(const EvaluateOptions& options) {
  if (options.each && !options.with_effects)
    throw UsageError("--each repeats the gap workflow, which only --with-effects runs");
  if (options.wheel_mismatch == 0.0) return;
  if (options.calibrate != Calibrate::each)
    throw UsageError("--wheel-mismatch gives each attempt a robot of its own; add --calibrate each");
  if (options.with_effects && !options.each)
    throw UsageError("--wheel-mismatch gives each attempt a robot of its own; add --each to --with-effects");
}

ExitStatus run_evaluate(const EvaluateOptions& options, Streams streams) {
  check(options);
  EvaluationPlan plan = plan_of(options);
  if (!options.output.empty()) make_output_folder(options.output, options);
  ProgressLine progress(streams.err);
  const auto say = progress.callback();
  const auto run = [&](const EvaluationPlan& of_plan) {
    return run_attempts(of_plan, options.runs, options.threads, [&](std::size_t done) {
      say(std::to_string(done) + " of " + std::to_string(options.runs) + " attempts",
          static_cast<double>(done) / static_cast<double>(options.runs));
    });
  };
  std::string found;
  if (options.with_effects && !options.each) {
    say("the gap workflow, once", 0.0);
    found = learn_once(plan);
  }
  if (options.calibrate == Calibrate::once) plan.calibrated = calibrate(plan, 0);
  const auto outcomes = run(plan);
  if (plan.learn_each) found = names_of(outcomes);
  const auto rows = offset_rows(outcomes, options.seed);
  nlohmann::ordered_json json{{"robot", plan.robot.name}, {"route", plan.route.name},
                              {"runs", options.runs},     {"seed", options.seed},
                              {"found", found},           {"models", offset_json(rows)}};
  if (options.wheel_mismatch > 0.0) json["wheel_mismatch"] = options.wheel_mismatch;
  std::vector<OffsetRow> of_one_calibration;
  if (options.calibrate == Calibrate::both) {
    of_one_calibration = offset_rows(run(with_one_calibration(plan)), options.seed);
    json["one_calibration"] = offset_json(of_one_calibration);
  }
  progress.clear();
  if (!options.output.empty()) {
    write(fs::path(options.output) / "evaluation.json", json_text(json) + "\n");
    write_end_points(options.output, outcomes, streams);
  }
  if (options.json) {
    streams.out << json_text(json) << "\n";
  } else {
    streams.out << options.runs << " attempts per model on robot '" << plan.robot.name << "', route '"
                << plan.route.name << "', seed " << options.seed << "\n\n";
    print_offset_table(streams.out, rows, of_one_calibration);
    if (!found.empty()) streams.out << "\nthe gap workflow, " << found << "\n";
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
  command
      ->add_option("--calibrate", options->calibrate,
                   "Before each attempt, once before all, or both, one table beside the other")
      ->transform(one_of<Calibrate>(
          {{"each", Calibrate::each}, {"once", Calibrate::once}, {"both", Calibrate::both}}))
      ->default_str("both");
  command
      ->add_option(
          "--drives", options->drives,
          "Calibration drives: as shipped, or as in the paper (short actions, random commands alone)")
      ->transform(one_of<Drives>({{"shipped", Drives::shipped}, {"paper", Drives::paper}}))
      ->default_str("shipped");
  command->add_flag("--with-effects", options->with_effects,
                    "Run the gap workflow once, and drive with what it found as well");
  command->add_flag("--each", options->each,
                    "Run the gap workflow before each attempt, on that attempt's own drives");
  command
      ->add_option(
          "--wheel-mismatch", options->wheel_mismatch,
          "Each attempt has wheels of its own, unlike by a fraction drawn with this standard deviation")
      ->check(CLI::Range(0.0, 0.05));
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
      "mean is at most 30 % above it.\nExample: wheelwright evaluate --runs 30 -o out/evaluation");
  return [options](Streams streams) { return run_evaluate(*options, streams); };
}

}  // namespace wheelwright::tools

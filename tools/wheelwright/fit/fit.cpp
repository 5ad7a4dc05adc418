// wheelwright fit: drive logs in, model file out.
#include <memory>
#include <optional>
#include <ostream>

#include "config/load/model_file.hpp"
#include "config/load/text_format.hpp"
#include "config/load/utc_now.hpp"
#include "model/gap/data_checks/data_gate.hpp"
#include "model/identification/fir_fit.hpp"
#include "model/identification/run_scales.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/fit/fit_arma.hpp"
#include "tools/wheelwright/fit/fit_json.hpp"
#include "tools/wheelwright/fit/fit_poses.hpp"
#include "tools/wheelwright/fit/fit_report.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

namespace wheelwright::tools {
namespace {

struct FitOptions {
  std::vector<std::string> logs;
  ImportOptions import;
  std::string output;
  std::string type = "fir";
  std::string order = "auto";
  std::size_t delay = 0;
  std::string method = "free-run";
  std::optional<double> max_command_m_s;
  bool json = false;
};

constexpr std::size_t largest_fir_order = 200;
constexpr std::size_t largest_arma_order = 30;

std::optional<std::size_t> parse_order(const std::string& text, std::size_t largest) {
  if (text == "auto") return std::nullopt;
  const bool digits =
      !text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t order = digits ? std::stoul(text) : 0;
  if (order < 1 || order > largest) {
    throw UsageError("--order is '" + text + "', but must be 'auto' or a whole number from 1 to " +
                     std::to_string(largest));
  }
  return order;
}

void check_type(const FitOptions& options) {
  if (options.type != "fir" && options.type != "arma") {
    throw UsageError("--type is '" + options.type + "', but must be fir or arma");
  }
  if (options.method != "free-run" && options.method != "equation-error") {
    throw UsageError("--method is '" + options.method + "', but must be free-run or equation-error");
  }
  if (options.type == "fir" && (options.delay > 0 || options.method != "free-run")) {
    throw UsageError("--delay and --method belong to --type arma");
  }
}

ArmaFitOptions arma_options(const FitOptions& options) {
  ArmaFitOptions result;
  result.order = parse_order(options.order, largest_arma_order);
  result.delay = options.delay;
  if (options.method == "equation-error") result.method = ArmaMethod::equation_error;
  const std::size_t order = result.order.value_or(result.largest_order);
  if (options.delay > order) {
    throw UsageError("--delay is " + std::to_string(options.delay) + ", but must be at most the order, " +
                     std::to_string(order));
  }
  return result;
}

// A model of counts that contradict their commands would be believed.
void refuse_contradictions(const std::vector<DriveLog>& runs) {
  for (const auto& run : runs) {
    for (const auto& fault : gap::gate(run).faults) {
      if (!fault.explains || !fault.what.starts_with("ticks_")) continue;
      throw DataRefusal(fault.log + ":" + std::to_string(fault.row) +
                        ": the data contradict themselves: " + fault.what);
    }
  }
}

// Of runs of one wheel the other, which stands beside it, says nothing.
void refuse_other_scale(const std::vector<DriveLog>& runs) {
  const auto outlier = find_scale_outlier(runs);
  if (!outlier) return;
  const DriveLog& run = runs[outlier->run];
  const DriveLog& other = runs[outlier->other];
  throw DataRefusal(run.name + ":" + std::to_string(run.first_line) + ": its counts go " +
                    config::fixed_number(outlier->factor, 2) +
                    " times as far for their commands as those of " + other.name + ":" +
                    std::to_string(other.first_line) +
                    "; give its own scale (--set wheels.metres_per_count), or leave it out");
}

std::vector<DriveLog> load_training_runs(const FitOptions& options, std::ostream& err,
                                         ProgressLine& progress) {
  auto runs = with_wheel_on_both_sides(load_all_runs({options.logs, options.import}, err, progress));
  progress.callback()("checking the data", 0.2);
  check_runs_of_one_robot(runs, gap::hold_poses_alone(runs));
  for (const auto& run : runs) {
    if (const auto impossible = find_impossible_command(run, options.max_command_m_s)) {
      throw UsageError(*impossible + ", or allow it with --max-command");
    }
    if (const auto impossible = find_impossible_counts(run, options.max_command_m_s)) {
      throw UsageError(*impossible);
    }
  }
  refuse_contradictions(runs);
  refuse_other_scale(runs);
  return runs;
}

RobotModel to_robot_model(const FitReport& report, const std::vector<std::string>& sources) {
  RobotModel model;
  model.robot = robot_name(report.runs.front());
  model.created = config::utc_now();
  model.source = sources;
  model.linear_part = report.model();
  model.left_fit = report.left();
  model.right_fit = report.right();
  return model;
}

// Rows that are missing may be why too few are left.
[[noreturn]] void refuse(const Refusal& refusal, const std::vector<DriveLog>& runs) {
  std::string holes;
  for (const auto& run : runs) {
    for (const auto& line : describe_holes(run)) holes += (holes.empty() ? " (" : ", ") + line;
  }
  throw DataRefusal(refusal.reason + (holes.empty() ? "" : holes + ")"));
}

FitReport fit_fir_to(const FirFitOptions& fit_options, std::vector<DriveLog> runs, ProgressLine& progress) {
  const auto say = progress.callback();
  say("fitting", 0.3);
  auto fit = fit_fir(runs, fit_options);
  if (!fit) refuse(fit.error(), runs);
  say("free run and settled speeds", 0.8);
  return report_of(std::move(*fit), std::move(runs));
}

FitReport fit_arma_to(const ArmaFitOptions& fit_options, std::vector<DriveLog> runs, std::ostream& err,
                      ProgressLine& progress) {
  progress.clear();
  auto fit = fit_arma(runs, fit_options, err);
  if (!fit) refuse(fit.error(), runs);
  progress.callback()("settled speeds", 0.9);
  return report_of(std::move(*fit), std::move(runs));
}

FitReport fit_counts(const FitOptions& options, std::vector<DriveLog> runs, std::ostream& err,
                     ProgressLine& progress) {
  if (options.type == "arma") return fit_arma_to(arma_options(options), std::move(runs), err, progress);
  FirFitOptions fit_options;
  fit_options.length = parse_order(options.order, largest_fir_order);
  fit_options.longest = largest_fir_order;
  return fit_fir_to(fit_options, std::move(runs), progress);
}

// What is wrong with them is said before anything is read.
void check_order(const FitOptions& options) {
  if (options.type == "arma") {
    arma_options(options);
  } else {
    parse_order(options.order, largest_fir_order);
  }
}

void fit_and_save_by_counts(const FitOptions& options, std::vector<DriveLog> runs, Streams streams,
                            ProgressLine& progress) {
  const FitReport report = fit_counts(options, std::move(runs), streams.err, progress);
  progress.clear();
  config::save_model(to_robot_model(report, options.logs), options.output);
  if (options.json) {
    streams.out << json_text(fit_json(report, options.output)) << "\n";
  } else {
    print_fit(streams.out, report);
  }
}

void fit_and_save_by_poses(const FitOptions& options, const std::vector<DriveLog>& runs, Streams streams) {
  if (options.order != "auto" || options.delay > 0 || options.method != "free-run") {
    throw UsageError(
        "--order, --delay and --method are for fits of encoder counts, but these runs hold poses alone");
  }
  const gap::PoseFit fit = fit_poses(runs, streams.err);
  RobotModel model;
  model.robot = robot_name(runs.front());
  model.created = config::utc_now();
  model.source = options.logs;
  model.linear_part = fit.linear_part;
  model.left_fit = fit.wheel_fit(fit.left_gain, true);
  model.right_fit = fit.wheel_fit(fit.right_gain, false);
  config::save_model(model, options.output);
  if (options.json) {
    streams.out << json_text(pose_fit_json(fit, runs.size(), options.output)) << "\n";
  } else {
    print_pose_fit(streams.out, fit, runs.size());
  }
}

ExitStatus run_fit(const FitOptions& options, Streams streams) {
  check_type(options);
  if (options.max_command_m_s && !(*options.max_command_m_s > 0.0)) {
    throw UsageError("--max-command must be above 0 m/s");
  }
  check_output({options.output, config::OutputKind::model}, options.logs);
  check_order(options);
  ProgressLine progress(streams.err);
  auto runs = load_training_runs(options, streams.err, progress);
  if (gap::hold_poses_alone(runs)) {
    progress.clear();
    fit_and_save_by_poses(options, runs, streams);
  } else {
    fit_and_save_by_counts(options, std::move(runs), streams, progress);
  }
  if (!options.json) streams.out << "  wrote " << options.output << "\n";
  return ExitStatus::done;
}

}  // namespace

Action add_fit(CLI::App& app) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Identify a model of the robot from drive logs");
  command
      ->add_option("LOG", options->logs,
                   "Drive logs with encoder counts, or with reference poses alone; all their runs are used")
      ->required();
  command->add_option("-o,--output", options->output, "Model file to write")->required();
  add_import_options(*command, options->import);
  command->add_option("--type", options->type, "fir (moving average) or arma")->capture_default_str();
  command
      ->add_option("--order", options->order,
                   "Length of the response (fir) or of the past (arma, up to 30) in periods, or auto")
      ->capture_default_str();
  command->add_option("--delay", options->delay, "arma: periods in which a command surely does nothing")
      ->capture_default_str();
  command
      ->add_option(
          "--method", options->method,
          "arma: free-run (fits travel predicted from commands alone) or equation-error (the paper's)")
      ->capture_default_str();
  command->add_option("--max-command", options->max_command_m_s,
                      "Largest wheel command that the robot takes, m/s; larger ones are refused as garbage");
  command->add_flag("--json", options->json, "Print the result of the fit as JSON, in m/s and m");
  command->footer(
      "A run is cut where rows are missing. Steps and a bend of the speed curve that held commands show are "
      "reported.\n"
      "Exit status: 0 a model was written, 1 the data cannot show one, 2 bad usage or bad logs.\n"
      "Example: wheelwright fit run1.csv run2.csv -o robot.yaml");
  return [options](Streams streams) { return run_fit(*options, streams); };
}

}  // namespace wheelwright::tools

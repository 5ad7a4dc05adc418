// wheelwright report: what a run, a calibration or an evaluation came to, as a page.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/text_format.hpp"
#include "model/prediction/free_run.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/common/progress_line.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"
#include "tools/wheelwright/logs/log_input.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/report/calibration_section.hpp"
#include "tools/wheelwright/report/evaluation_section.hpp"
#include "tools/wheelwright/report/lateness_section.hpp"
#include "tools/wheelwright/report/run_section.hpp"
#include "tools/wheelwright/report/wheel_plots.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string log;
  ImportOptions import;
  std::string output;
  std::string model;
  std::string truth;
  bool orders = false;
  bool json = false;
};

std::string about(const RunMaterial& run) {
  std::string text;
  for (const auto& [key, value] : run.metadata) {
    if (key != "robot" && key != "wheel_base_m" && key != "period_s") continue;
    text += (text.empty() ? "" : "; ") + key + " " + value;
  }
  const auto add_length = [&text](const auto& rows) {
    if (rows.empty()) return false;
    const double length_s = rows.back().t_s - rows.front().t_s;
    text += "; " + config::fixed_number(length_s, 1) + " s, " + std::to_string(rows.size()) + " rows";
    return true;
  };
  if (!add_length(run.ticks) && run.drive) add_length(run.drive->samples);
  return "<p class=\"quiet\">" + html::escaped(text) + "</p>\n";
}

std::string refusals(const CalibrationMaterial& material) {
  std::string text;
  for (const auto& reason : material.refusals) {
    text += html::element("p", "A calibration was refused: " + reason);
  }
  return text;
}

// A drive log from anywhere: commands, wheels, and what the model makes of them.
std::string log_section(const DriveLog& log, const std::optional<RobotModel>& model) {
  const auto motion = model ? free_run(*model, log) : std::vector<PredictedMotion>{};
  const double whole_s = log.samples.back().t_s - log.samples.front().t_s;
  std::vector<Plot> plots = sequence_plots(log, motion, whole_s);
  std::vector<DrawnRun> drawn;
  if (model) drawn.push_back({"model", Ink::accent, &motion});
  if (model && log.has_ticks()) plots.push_back(travel_error_plot(log, drawn));
  if (has_path(log)) plots.push_back(path_plot(log, drawn));
  return html::element("h2", "The log") + figures_html(draw(plots));
}

// A run of the daemon or a log of this project, else any file that can be imported.
RunMaterial material_of(const ReportOptions& options, const std::optional<RobotModel>& model,
                        std::ostream& err) {
  std::error_code ignored;
  const bool is_bag = fs::exists(fs::path(options.log) / "metadata.yaml", ignored);
  try {
    if (options.import.empty() && !is_bag) return load_run_material(options.log, model);
  } catch (const config::LogError&) {
    if (fs::is_directory(options.log, ignored)) throw;
  }
  RunMaterial material;
  material.name = fs::path(options.log).filename().string();
  material.drive = load_one_run({{options.log}, options.import}, err);
  for (const auto& [key, value] : material.drive->other_metadata) material.metadata[key] = value;
  material.model = model;
  return material;
}

std::string run_page(const ReportOptions& options, ProgressLine& progress, std::ostream& err) {
  const auto model = options.model.empty() ? std::nullopt : std::optional(config::load_model(options.model));
  const auto truth =
      options.truth.empty() ? std::nullopt : std::optional(config::CsvTable::load(options.truth));
  const auto say = progress.callback();
  say("reading and fitting", 0.0);
  const RunMaterial run = material_of(options, model, err);
  std::string body = html::element("h1", "Run " + run.name) + about(run) + refusals(run.calibration);
  say("drawing the run", 0.4);
  const std::string of_run = run_section(run, truth);
  body += of_run;
  if (of_run.empty() && run.drive) body += log_section(*run.drive, run.model);
  if (run.lateness) body += lateness_section(*run.lateness);
  say("drawing the calibration", 0.6);
  body += encoder_scale_section(run.calibration);
  body += response_section(run.calibration);
  body += arma_section(run.calibration, options.orders);
  if (run.model && run.calibration.responses.empty()) body += model_section(*run.model);
  return html::page("Run " + run.name, body);
}

std::string default_output(const std::string& log) {
  std::error_code ignored;
  const fs::path path = log;
  if (fs::is_directory(path, ignored)) return (path / "report.html").string();
  return (path.parent_path() / (path.stem().string() + ".html")).string();
}

void refuse_gap_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / "gap.json", ignored)) return;
  throw UsageError(folder.string() + ": is of wheelwright gap, whose page is there already: " +
                   (folder / "report.html").string());
}

ExitStatus run_report(const ReportOptions& options, Streams streams) {
  refuse_gap_folder(options.log);
  const std::string output = options.output.empty() ? default_output(options.log) : options.output;
  check_output({output, config::OutputKind::page},
               {options.log, options.model, options.truth, options.import.mapping});
  ProgressLine progress(streams.err);
  const std::string page = is_evaluation(options.log)
                               ? html::page("Evaluation", html::element("h1", "The paper's Table II") +
                                                              evaluation_section(options.log))
                               : run_page(options, progress, streams.err);
  progress.clear();
  write({output, config::OutputKind::page}, page);
  if (options.json) {
    streams.out << json_text(nlohmann::ordered_json{{"wrote", output}, {"bytes", page.size()}}) << "\n";
  } else {
    streams.out << "wrote " << output << "\n";
  }
  return ExitStatus::done;
}

}  // namespace

Action add_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      app.add_subcommand("report", "What a run, a calibration or an evaluation came to, as a page");
  command
      ->add_option(
          "LOG", options->log,
          "Folder of a run or of an evaluation, a drive log, a pose log, or any log that import reads")
      ->required();
  command->add_option("-o,--output", options->output,
                      "Page to write (default: report.html in the folder, or beside the log)");
  add_import_options(*command, options->import);
  command->add_option("--model", options->model, "Model to hold against the log, instead of the run's own");
  command->add_option("--truth", options->truth,
                      "True motion that roomba-sim wrote, to draw beside the route");
  command->add_flag("--orders", options->orders,
                    "Judge ARMA orders 1 to 15 on the random drive, which takes some seconds");
  command->add_flag("--json", options->json, "The page that was written, as JSON");
  command->footer(
      "The page is self-contained and needs no network. Pictures need gnuplot (package gnuplot-nox).\n"
      "Example: wheelwright report runs/2026-11-21T06-48-44Z -o report.html");
  return [options](Streams streams) { return run_report(*options, streams); };
}

}  // namespace wheelwright::tools

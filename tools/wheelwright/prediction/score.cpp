// wheelwright score: how far a model's free run and measured runs are apart.
#include "model/prediction/score.hpp"

#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/model_file.hpp"
#include "config/load/text_format.hpp"
#include "model/prediction/open_loop_runs.hpp"
#include "model/prediction/segments.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"
#include "tools/wheelwright/logs/log_input.hpp"
#include "tools/wheelwright/prediction/score_json.hpp"

namespace wheelwright::tools {
namespace {

using nlohmann::ordered_json;

struct ScoreOptions {
  std::string model;
  std::vector<std::string> logs;
  ImportOptions import;
  bool json = false;
};

struct ScoredRun {
  std::string name;
  std::size_t rows = 0;
  Score score;
  std::optional<WheelPair> end_error_m;
};

// In thousandths, as the table shows everything; a dash where there is nothing.
std::string thousandths(const std::optional<double>& value) {
  return value ? config::fixed_number(1000.0 * *value, 1) : "-";
}

std::string thousandths(const std::optional<AtHorizon>& figure) {
  if (!figure) return "-";
  return config::fixed_number(1000.0 * figure->value, 1) + " / " +
         config::fixed_number(figure->horizon_s, 1) + " s";
}

void print_row(std::ostream& out, const ScoredRun& run) {
  std::optional<double> left;
  std::optional<double> right;
  if (run.end_error_m) {
    left = run.end_error_m->left;
    right = run.end_error_m->right;
  }
  out << std::right << std::setw(7) << run.rows << std::setw(10) << thousandths(run.score.wheel_speed_rms_m_s)
      << std::setw(12) << thousandths(run.score.distance_rms_m) << std::setw(10) << thousandths(left)
      << std::setw(10) << thousandths(right) << std::setw(17) << thousandths(run.score.position_rms_m)
      << std::setw(17) << thousandths(run.score.heading_rms_rad) << "  " << run.name << "\n";
}

void print_table(std::ostream& out, const std::vector<ScoredRun>& runs, const Score& all) {
  out << "          speed    distance    distance at end         position          heading\n"
         "   rows  mm/s RMS     mm RMS   left mm  right mm  mm RMS / after mrad RMS / after  log\n";
  std::size_t rows = 0;
  for (const auto& run : runs) {
    print_row(out, run);
    rows += run.rows;
  }
  if (runs.size() > 1) print_row(out, {"all", rows, all, std::nullopt});
}

std::string run_name(const DriveLog& log, bool only_run_of_file) {
  return only_run_of_file ? log.name : log.name + ":" + std::to_string(log.first_line);
}

// Adds the run to `all` as well.
ScoredRun scored_run(const RobotModel& model, const DriveLog& log, bool only_run_of_file, ScoreSums& all) {
  const auto motions = open_loop_runs(model, log);
  const std::vector<Prediction> predictions(motions.begin(), motions.end());
  ScoreSums sums;
  add_segments(predictions, log, model.linear_part.period_s, sums);
  add_segments(predictions, log, model.linear_part.period_s, all);
  ScoredRun run{run_name(log, only_run_of_file), log.samples.size(), sums.score(), std::nullopt};
  // Through a hole no model can say how far the wheels went.
  if (find_holes(log).empty()) run.end_error_m = end_distance_error_m(motions.front(), log);
  return run;
}

ExitStatus run_score(const ScoreOptions& options, Streams streams) {
  const RobotModel model = config::load_model(options.model);
  ScoreSums sums;
  std::vector<ScoredRun> runs;
  ProgressLine progress(streams.err);
  const auto say = progress.callback();
  for (std::size_t i = 0; i < options.logs.size(); ++i) {
    const std::string& path = options.logs[i];
    const auto logs = load_all_runs({{path}, options.import}, streams.err, progress);
    for (const auto& log : logs) {
      progress.clear();
      check_log_for_model(log, model.linear_part, streams.err);
      say("scoring " + path, (static_cast<double>(i) + 0.3) / static_cast<double>(options.logs.size()));
      runs.push_back(scored_run(model, log, logs.size() == 1, sums));
    }
  }
  progress.clear();
  const Score all = sums.score();
  if (all.empty())
    throw DataRefusal("the logs hold neither encoder counts nor reference poses to compare with");
  if (options.json) {
    streams.out << json_text(score_to_json(all), -1) << "\n";
  } else {
    print_table(streams.out, runs, all);
  }
  return ExitStatus::done;
}

}  // namespace

Action add_score(CLI::App& app) {
  const auto options = std::make_shared<ScoreOptions>();
  CLI::App* command = app.add_subcommand("score", "How far a model's free run and measured runs are apart");
  command->add_option("MODEL", options->model, "Model file")->required();
  command->add_option("LOG", options->logs, "Drive logs with encoder counts or reference poses")->required();
  add_import_options(*command, options->import);
  command->add_flag("--json", options->json, "All logs together as JSON, in m/s, m and rad");
  command->footer(
      "Errors are predicted minus measured; segments between gaps in the rows start each from its own "
      "first row. A model with a rug, a slope or an eccentric wheel is reset every 10 s to the measured pose "
      "and wheel travel.\nExample: "
      "wheelwright score robot.yaml run2.csv run3.csv");
  return [options](Streams streams) { return run_score(*options, streams); };
}

}  // namespace wheelwright::tools

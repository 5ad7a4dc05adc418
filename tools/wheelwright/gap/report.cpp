#include "tools/wheelwright/gap/report.hpp"

#include <algorithm>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "model/gap/error_sources/residual_table.hpp"
#include "model/gap/fit/reference_alignment.hpp"
#include "model/gap/runs/run.hpp"
#include "model/prediction/open_loop_runs.hpp"
#include "tools/wheelwright/gap/check_section.hpp"
#include "tools/wheelwright/gap/gap_text.hpp"
#include "tools/wheelwright/gap/report_tables.hpp"
#include "tools/wheelwright/gap/run_plots.hpp"
#include "tools/wheelwright/gap/simulation_section.hpp"
#include "tools/wheelwright/page/html.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::size_t max_drawn_runs = 3;

// All logs without their faults, with what the analysis found of their references.
std::vector<gap::GatedLog> gated(std::span<const DriveLog> train, std::span<const DriveLog> test,
                                 const gap::GapAnalysis& analysis) {
  std::vector<DriveLog> all(train.begin(), train.end());
  all.insert(all.end(), test.begin(), test.end());
  std::vector<gap::GatedLog> result = gap::gate_together(all);
  for (auto& one : result) {
    const gap::GapRun run = gap::make_gap_run(one.log, one.flags, one.log.period_s);
    gap::note_references(one.log, run, analysis.search.final.model);
  }
  return result;
}

// The first few of the runs on which the accepted model is shown.
std::vector<DriveLog> heldout_runs(const gap::GapAnalysis& analysis, std::span<const gap::GatedLog> all) {
  std::vector<DriveLog> runs;
  for (const auto& one : all) {
    const bool held_out = std::ranges::find(analysis.tested, one.log.name) != analysis.tested.end();
    if (held_out && runs.size() < max_drawn_runs) runs.push_back(one.log);
  }
  return runs;
}

std::string figures_section(const gap::GapAnalysis& analysis, const std::vector<DriveLog>& runs) {
  const bool changed = !analysis.found.empty() || !analysis.linear_changes.empty();
  const Figures drawn =
      draw(run_plots(analysis.before, changed ? std::optional(analysis.after) : std::nullopt, runs));
  if (drawn.problem.empty() && drawn.figures.empty()) return "";
  const bool told = changed && std::ranges::any_of(runs, [&](const DriveLog& run) {
                      return is_reset_to_measured_pose(analysis.after, run);
                    });
  return html::element("h2", analysis.tail_held_out ? "The run, simulated"
                             : analysis.untouched   ? "Untouched runs, simulated"
                                                    : "Held-out runs, simulated") +
         html::element(
             "p",
             std::string("From the commands of the whole run and the pose at its start. ") +
                 (told ? "The effects that were added depend on pose and wheel travel, so the model is reset "
                         "to the measured ones every 10 s; its path goes on from where it was."
                       : "")) +
         figures_html(drawn);
}

std::string head(const gap::GapAnalysis& analysis) {
  const std::string verdict(gap::verdict_name(analysis.verdict));
  std::string text = html::element("h1", "What the simulation lacks");
  text +=
      "<p class=\"verdict\"><strong>" + verdict + "</strong>: " + html::escaped(analysis.summary) + "</p>\n";
  std::string line = std::to_string(analysis.train_runs) +
                     (analysis.train_runs == 1 ? " training run, " : " training runs, ") +
                     std::to_string(analysis.test_runs) + " held out";
  if (analysis.untouched) line += ", " + std::to_string(analysis.tested.size()) + " untouched";
  if (analysis.tail_held_out) line = "1 run, its last third held out";
  if (!analysis.after.robot.empty()) line += "; robot " + analysis.after.robot;
  if (!analysis.after.created.empty()) line += "; " + analysis.after.created;
  return text + "<p class=\"quiet\">" + html::escaped(line) + "</p>\n";
}

}  // namespace

std::string gap_report(const gap::GapAnalysis& analysis, std::span<const DriveLog> train,
                       std::span<const DriveLog> test, const std::optional<gap::NextExperiment>& next,
                       const ComparedSimulation* simulation) {
  const bool fitted = !analysis.after.linear_part.left.from_left.empty();
  const std::vector<gap::GatedLog> all = gated(train, test, analysis);
  std::string body = head(analysis);
  if (simulation != nullptr) body += simulation_section(*simulation);
  body += findings_section(analysis);
  body += linear_changes_section(analysis);
  body += check_section(analysis);
  body += where_section(analysis);
  if (fitted && analysis.verdict == gap::Verdict::unnamed) {
    body += residual_section(gap::residual_table(analysis.after, all));
  }
  body += gap_section(analysis);
  if (fitted) body += figures_section(analysis, heldout_runs(analysis, all));
  body += faults_section(analysis);
  if (next) {
    body +=
        html::element("h2", "What to drive next") + html::element("p", experiment_text(*next)) +
        "<p class=\"quiet\">Its commands are in next_experiment.csv: <code>wheelwrightd --config "
        "my_robot.yaml "
        "--commands next_experiment.csv</code> drives them, and the log of that run goes beside these.</p>\n";
  }
  body += limits_section(analysis);
  body += search_section(analysis);
  return html::page("Gap report: " + std::string(gap::verdict_name(analysis.verdict)), body);
}

}  // namespace wheelwright::tools

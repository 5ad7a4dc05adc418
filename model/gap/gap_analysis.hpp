// The gap workflow: where simulation and measurement disagree, what is missing, how sure that is, and how
// much of the gap closes on runs that were not used (GAP.md, the recipe).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "model/drive_log.hpp"
#include "model/gap/adequacy/predictive_check.hpp"
#include "model/gap/finding.hpp"
#include "model/gap/gap_figures.hpp"
#include "model/gap/gap_search.hpp"
#include "model/gap/gathered_runs.hpp"
#include "model/gap/linear_changes/linear_changes.hpp"
#include "model/gap/regimes.hpp"
#include "model/gap/testability.hpp"
#include "model/robot_model.hpp"
#include "model/score.hpp"

namespace wheelwright::gap {

enum class Verdict { named, nothing_missing, unnamed, ambiguous, not_testable, bad_data };
std::string_view verdict_name(Verdict verdict);

struct GapAnalysis {
  Verdict verdict = Verdict::nothing_missing;
  std::string summary;  // one or two sentences for a person
  std::vector<Finding> found;
  std::vector<Regime> where;
  GapFigures train;
  GapFigures test;
  std::vector<Untestable> not_testable;
  std::vector<Detectable> detectable;
  std::vector<DataFault> data_faults;
  RobotModel before;  // the linear model alone
  RobotModel after;   // with what was found
  GapSearch search;   // the path, for the report
  std::size_t train_runs = 0;
  std::size_t test_runs = 0;
  std::vector<std::string> trained;          // names of runs
  std::vector<std::string> held_out;         // names of those by which effects were accepted
  std::vector<std::string> tested;           // names of those of `test` and `check`: held out, or untouched
  bool untouched = false;                    // whether these took no part in any choice
  std::vector<LinearChange> linear_changes;  // of the model that was given
  PredictiveCheck check;                     // of the accepted model, on the held-out runs
  bool tail_held_out = false;                // a single run: its last third stands in for a run of its own
};

struct GapOptions {
  std::optional<RobotModel>
      model;  // whose gap is looked for; without it, that of the linear model fitted here
  SearchLimits limits;
};

// `test` may be empty: then the last runs of `train` are held out whole, or the last third of a single run.
// Where a gap shows in several runs but in none of those held out, one of the several is held out instead.
// Refuses logs that do not belong together and logs too short to hold anything out.
tl::expected<GapAnalysis, GapRefusal> analyse_gap(std::span<const DriveLog> train,
                                                  std::span<const DriveLog> test, const GapOptions& options,
                                                  const ForEach& for_each, const Progress& progress);

}  // namespace wheelwright::gap

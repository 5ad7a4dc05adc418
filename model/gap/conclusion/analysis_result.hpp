// What an analysis came to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/gap/adequacy/predictive_check.hpp"
#include "model/gap/candidates/testability.hpp"
#include "model/gap/conclusion/finding.hpp"
#include "model/gap/error_sources/error_sources.hpp"
#include "model/gap/figures/figures.hpp"
#include "model/gap/linear_changes/linear_changes.hpp"
#include "model/gap/selection/search.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

enum class Verdict { named, nothing_missing, unnamed, ambiguous, not_testable, bad_data };
std::string_view verdict_name(Verdict verdict);

// Which runs the predictive check is made on: untouched ones where there are some; all, where no effect was
// accepted, so that none was chosen by any run.
enum class CheckedRuns { untouched, held_out, all };

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
  double linear_gain_nats = 0.0;             // of the held-out runs' log likelihood, by these
  // Beside a simulation: names of effects that have to be other than its own (needed_differences.hpp).
  std::vector<std::string> differing_effects;
  PredictiveCheck check;         // of the accepted model
  double names_gain_nats = 0.0;  // of all its effects, in the runs of `check`
  CheckedRuns checked = CheckedRuns::held_out;
  bool tail_held_out = false;  // a single run: its last third stands in for a run of its own
};

}  // namespace wheelwright::gap

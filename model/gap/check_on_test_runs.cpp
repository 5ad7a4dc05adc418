#include "model/gap/check_on_test_runs.hpp"

#include <algorithm>

#include "model/gap/conclusion/check_verdict.hpp"
#include "model/gap/conclusion/confirmation.hpp"
#include "model/gap/conclusion/withdrawal.hpp"
#include "model/gap/fit/reference_alignment.hpp"

namespace wheelwright::gap {
namespace {

RunSet every_run(const GatheredRuns& runs) {
  RunSet all = runs.train;
  for (const RunSet* more : {&runs.test, &runs.untouched}) {
    for (std::size_t r = 0; r < more->runs.size(); ++r) all.add(more->runs[r], more->logs[r]);
  }
  return all;
}

void note_confirmation(GapAnalysis& result, const Confirmation& confirmation) {
  const auto& effects = result.search.final.model.effects;
  result.check = confirmation.check;
  result.names_gain_nats = confirmation.gain_nats;
  result.checked = effects.empty()    ? CheckedRuns::all
                   : result.untouched ? CheckedRuns::untouched
                                      : CheckedRuns::held_out;
  for (std::size_t i = 0; i < confirmation.effect_nats.size(); ++i) {
    const auto found = std::ranges::find_if(
        result.found, [&](const Finding& one) { return one.setting.name == effects[i].info->name; });
    if (found == result.found.end()) continue;
    found->test_gain_nats = confirmation.effect_nats[i];
    found->acts_untouched = confirmation.acts[i];
  }
}

// Figures of the held-out runs have served in the choice of effects.
void show_untouched_figures(SplitAnalysis& analysis) {
  GapAnalysis& result = analysis.result();
  const RunSet& untouched = analysis.runs().untouched;
  result.tested.clear();
  for (const GapRun& run : untouched.runs) result.tested.push_back(run.name);
  result.test = analysis.figures(result.before, result.after, untouched.logs);
  result.test.floor = analysis.slow_floor(untouched.logs);
}

void meet_test_runs(SplitAnalysis& analysis, const ParallelFor& parallel_for) {
  GapAnalysis& result = analysis.result();
  GatheredRuns& runs = analysis.runs();
  result.untouched = !runs.untouched.runs.empty();
  RunSet& test = result.untouched ? runs.untouched : runs.test;
  const TrialModel& accepted = result.search.final.model;
  for (std::size_t r = 0; r < test.logs.size(); ++r) note_references(test.logs[r], test.runs[r], accepted);
  RunSet all = accepted.effects.empty() ? every_run(runs) : RunSet{};
  note_confirmation(result, confirm(analysis.train(), result.search, accepted.effects.empty() ? all : test,
                                    result.untouched, parallel_for));
  if (result.untouched) show_untouched_figures(analysis);
}

// By the names at their values, and, in untouched runs, within their intervals.
bool something_else_is_the_larger_part(const SplitAnalysis& analysis, const ParallelFor& parallel_for) {
  const GapAnalysis& result = analysis.result();
  const GapFigures& test = result.tail_held_out ? result.train : result.test;
  if (!explains_the_smaller_part(result, test)) return false;
  if (!result.untouched) return true;
  const RunSet& untouched = analysis.runs().untouched;
  const RobotModel within =
      whole_model_of(likeliest_within_intervals(analysis.train(), result.search, untouched, parallel_for),
                     analysis.origin());
  const GapFigures figures = analysis.figures(result.before, within, untouched.logs);
  return explains_the_smaller_part(result, figures);
}

bool has_other_names(const GapAnalysis& result, const std::vector<std::string>& names) {
  return static_cast<std::size_t>(std::ranges::count_if(result.found, [](const Finding& found) {
           return found.setting.name != dropout_name;
         })) > names.size();
}

// Of several names, those that the untouched runs do not confirm.
std::string withdraw_unconfirmed_names(SplitAnalysis& analysis, const ParallelFor& parallel_for) {
  const std::vector<std::string> names = unconfirmed_names(analysis.result());
  if (names.empty() || !has_other_names(analysis.result(), names)) return "";
  analysis.withdraw(names);
  meet_test_runs(analysis, parallel_for);
  return unconfirmed_in_words(names);
}

}  // namespace

void check_on_test_runs(SplitAnalysis& analysis, const ParallelFor& parallel_for) {
  meet_test_runs(analysis, parallel_for);
  GapAnalysis& result = analysis.result();
  std::string unconfirmed;
  if (result.linear_changes.empty()) unconfirmed = withdraw_unconfirmed_names(analysis, parallel_for);
  const bool something_is_left = something_else_is_the_larger_part(analysis, parallel_for);
  const bool closes_nothing = !unconfirmed_names(result).empty() ||
                              (!analysis.names_small_effects() && closes_nothing_untouched(result));
  if (!result.linear_changes.empty() || !(something_is_left || closes_nothing)) {
    apply_check(result);
    result.summary += unconfirmed;
    return;
  }
  const std::string part = something_is_left ? part_in_words(result) : not_seen_in_words(result);
  analysis.withdraw_names();
  meet_test_runs(analysis, parallel_for);
  apply_check(result);
  if (result.verdict == Verdict::nothing_missing && something_is_left) {
    result.verdict = Verdict::unnamed;
    result.summary = "Something is missing that no effect of the library explains.";
  }
  result.summary += part;
}

}  // namespace wheelwright::gap

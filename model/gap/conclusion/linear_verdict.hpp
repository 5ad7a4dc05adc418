// What linear changes make of an answer.
#pragma once

#include <optional>
#include <string>

#include "model/gap/conclusion/analysis_result.hpp"
#include "model/gap/conclusion/found_model.hpp"
#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/linear_changes/linear_changes.hpp"

namespace wheelwright::gap {

// How the data differ from the linear part of the given model (`origin`), beside the effects of what was
// accepted. A model of another period is not compared.
LinearChanges changes_of_linear_part(const TrialModel& accepted, const ModelOrigin& origin,
                                     const FitProblem& train, const FitProblem& heldout);

// A longer delay among the changes, as a finding of `transport_delay`.
std::optional<Finding> delay_finding(const std::vector<LinearChange>& changes, double heldout_gain_nats);

// The search fits a linear part of its own: what that of the given model (`origin`) lacks would go unsaid.
// Compares it with the data, beside what was accepted, and adds what differs to the answer; false where
// nothing does. A model of another period is not compared, and the summary says so.
bool add_linear_changes(GapAnalysis& analysis, const ModelOrigin& origin, const FitProblem& train,
                        const FitProblem& heldout);

// Says so of a given model whose period is not that of the logs; else empty.
std::string not_compared_in_words(const RobotModel& given, double period_s);

// Adds the changes to the answer and its summary. Where nothing else was found, they are the gap: a longer
// delay is named `transport_delay`, and stands in the model as that effect before the given linear part with
// its gains corrected; any other change leaves the verdict `unnamed` and the refitted linear part in the
// model. Figures are left to the caller.
void add_linear_changes(GapAnalysis& analysis, const LinearChanges& found, const RobotModel& given);

}  // namespace wheelwright::gap

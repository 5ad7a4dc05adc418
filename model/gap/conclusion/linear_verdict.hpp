// What linear changes make of an answer.
#pragma once

#include "model/gap/conclusion/analysis_result.hpp"
#include "model/gap/linear_changes/linear_changes.hpp"

namespace wheelwright::gap {

// Adds the changes to the answer and its summary. Where nothing else was found, they are the gap: a longer
// delay is named `transport_delay`, and stands in the model as that effect before the given linear part with
// its gains corrected; any other change leaves the verdict `unnamed` and the refitted linear part in the
// model. Figures are left to the caller.
void add_linear_changes(GapAnalysis& analysis, const LinearChanges& found, const RobotModel& given);

}  // namespace wheelwright::gap

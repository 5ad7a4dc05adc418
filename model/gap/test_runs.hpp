// What was accepted meets the runs that nothing was chosen by.
#pragma once

#include "model/gap/split_analysis.hpp"

namespace wheelwright::gap {

// Checks the accepted model on the untouched runs; where there are none, on the held-out ones; on all, where
// no effect was accepted. Effects that do not pass there are withdrawn, and the model without them is checked
// on the same runs. Sets the check and the figures of the result, and what they change of its verdict.
void check_on_test_runs(SplitAnalysis& analysis, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap

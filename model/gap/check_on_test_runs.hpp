// The check of an answer on the runs that nothing was chosen by.
#pragma once

#include "model/gap/split_analysis.hpp"

namespace wheelwright::gap {

// Checks the accepted model on the untouched runs; if there are none, on the held-out ones; if no effect was
// accepted, on all. Names that do not pass there (conclusion/withdrawal.hpp) are withdrawn, and the model
// without them is checked on the same runs. Sets the check and the figures of the result, and what they
// change of its verdict.
void check_on_test_runs(SplitAnalysis& analysis, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap

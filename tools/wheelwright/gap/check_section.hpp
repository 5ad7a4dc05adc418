// The predictive check, and the linear part of a given model, as sections of report.html and as text.
#pragma once

#include <string>

#include "model/gap/analysis.hpp"

namespace wheelwright::tools {

// Whether the accepted model explains the test runs, the statistics that say so, and the curve of one that
// failed.
std::string check_section(const gap::GapAnalysis& analysis);

// Empty without a given model, or where its linear part agrees with the data.
std::string linear_changes_section(const gap::GapAnalysis& analysis);

// What the runs of the test figures are: "untouched" or "held out".
std::string test_runs_text(const gap::GapAnalysis& analysis);

// "untouched", "held-out" or "all".
std::string checked_text(gap::CheckedRuns checked);

// As in "check on untouched runs: passed (p = 0.31)"; empty where nothing was checked.
std::string check_text(const gap::GapAnalysis& analysis);

}  // namespace wheelwright::tools

// What an analysis comes to: one word, and a sentence or two for a person.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/conclusion/analysis_result.hpp"
#include "model/gap/figures/free_run_figures.hpp"
#include "model/gap/runs/run_set.hpp"

namespace wheelwright::gap {

// Whether the data alone are the answer, before any search: they contradict themselves, or show no motion.
// Then verdict, summary and what is not testable are set.
bool data_decide(GapAnalysis& analysis, const RunSet& train, const Testability& testability);

// Of a run that was held out: what each wheel travelled for each metre that the model predicts.
struct GainChange {
  std::string run;
  WheelPair gain{1.0, 1.0};
};

// Held-out runs may be another robot's, or the same one's on another day: gains that changed between runs,
// whose cause no run shows. Empty where the model explains them about as well as those that it was fitted to.
// The floors of the analysis are those of noise over seconds.
std::vector<GainChange> changed_gains(const GapAnalysis& analysis, const FitProblem& train,
                                      const FitProblem& heldout);

// What may be missing where nothing was found.
struct ResidualDiagnostics {
  Excess over_quick_noise;  // in floors of noise from reading to reading
  std::vector<GainChange> gain_changes;
  bool counted = false;  // whether the logs hold counts
};

// Sets verdict and summary, and `where` for gains that changed, from all else that the analysis holds. Its
// floors are those of noise over seconds.
void reach_verdict(GapAnalysis& analysis, const SearchLimits& limits, const ResidualDiagnostics& residual);

}  // namespace wheelwright::gap

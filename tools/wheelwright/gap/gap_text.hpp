// What the gap workflow found, for a person at a terminal.
#pragma once

#include <iosfwd>
#include <string>

#include "model/gap/analysis.hpp"
#include "model/gap/next_experiment/next_experiment.hpp"

namespace wheelwright::tools {

void print_gap(std::ostream& out, const gap::GapAnalysis& analysis);

// Which runs fitted parameters, decided on effects, and were used for nothing but the check.
std::string run_roles_text(const gap::GapAnalysis& analysis);

// By how much references and counts tell of other moments, as a sentence; empty where they do not.
std::string late_references_text(const gap::GapAnalysis& analysis);

// What to drive next, as one or two sentences.
std::string experiment_text(const gap::NextExperiment& next);

}  // namespace wheelwright::tools

// gap.json: what the gap workflow found, for programs. The format is a contract (README.md, gap.json).
#pragma once

#include <optional>
#include <string>

#include "model/gap/analysis.hpp"
#include "model/gap/next_experiment/next_experiment.hpp"

namespace wheelwright::tools {

// `next_file` holds the commands of `next`.
std::string gap_to_json(const gap::GapAnalysis& analysis, const std::optional<gap::NextExperiment>& next,
                        const std::string& next_file);

}  // namespace wheelwright::tools

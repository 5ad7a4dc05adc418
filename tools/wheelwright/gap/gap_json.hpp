// gap.json: what the gap workflow found, for programs. The format is a contract (README.md, gap.json).
#pragma once

#include <optional>
#include <string>

#include "model/gap/analysis.hpp"
#include "model/gap/next_experiment/next_experiment.hpp"
#include "tools/wheelwright/gap/compare_simulation.hpp"

namespace wheelwright::tools {

// `next_file` holds the commands of `next`; `simulation` is there where a simulator was compared.
std::string gap_to_json(const gap::GapAnalysis& analysis, const std::optional<gap::NextExperiment>& next,
                        const std::string& next_file, const ComparedSimulation* simulation = nullptr);

}  // namespace wheelwright::tools

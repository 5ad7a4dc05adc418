// report.html: what the gap workflow found, for a person. One self-contained file: tables,
// bars, and pictures by gnuplot where it is installed.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/gap/analysis.hpp"
#include "model/gap/next_experiment/next_experiment.hpp"
#include "model/log/drive_log.hpp"
#include "tools/wheelwright/gap/compare_simulation.hpp"

namespace wheelwright::tools {

// `train` and `test` are the logs that the analysis was made from; `test` may be empty.
std::string gap_report(const gap::GapAnalysis& analysis, std::span<const DriveLog> train,
                       std::span<const DriveLog> test, const std::optional<gap::NextExperiment>& next,
                       const ComparedSimulation* simulation = nullptr);

}  // namespace wheelwright::tools

// The gap workflow: where simulation and measurement disagree, what is missing, how sure that is, and how
// much of the gap closes on runs that were not used.
#pragma once

#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "model/gap/conclusion/analysis_result.hpp"
#include "model/gap/data_checks/gathered_runs.hpp"
#include "model/gap/fit/fit_problem.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

struct GapOptions {
  // Whose gap is looked for; without it, that of the linear model fitted here.
  std::optional<RobotModel> model = std::nullopt;
  // Whose gap is shown, and whose linear part is compared; its effects are not taken for given.
  std::optional<RobotModel> simulation = std::nullopt;
  std::optional<double> period_s = std::nullopt;  // of the models; else the shortest of the runs
  // Names effects that are beyond chance, too, where no figure of a free run shows them. A simulation's small
  // effects are no gap of its own, but the robot's sizes are compared with theirs.
  bool names_small_effects = false;
  SearchLimits limits = {};
};

// `test` may be empty: then the last runs of `train` are held out whole, or the last third of a single run.
// Where a gap shows in several runs but in none of those held out, one of the several is held out instead.
// Refuses logs that do not belong together and logs too short to hold anything out.
tl::expected<GapAnalysis, GapRefusal> analyse_gap(std::span<const DriveLog> train,
                                                  std::span<const DriveLog> test, const GapOptions& options,
                                                  const ParallelFor& parallel_for, const Progress& progress);

}  // namespace wheelwright::gap

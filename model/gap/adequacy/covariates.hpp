// What a residual may depend on, at each reading.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/gap/adequacy/dependence.hpp"
#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

inline constexpr std::string_view heading_name = "the heading";

// The pose of each run at each grid point by the reference of a second ago and the model's motion since: the
// noise of a reading must not be in its own covariate, where it would look like a dependence. Empty without
// dense references.
std::vector<std::vector<Pose>> predicted_poses(const FitProblem& problem, const TrialModel& model);

// Of a wheel: its command; of the body: the forward command; of both: the turning command, the time since the
// start, the time since a change of command, and heading and place by the predicted poses.
std::vector<Covariate> covariates_for(const FitProblem& problem, std::span<const std::vector<Pose>> poses,
                                      std::span<const ResidualTrack* const> tracks);

// How fast the robot is driven and turned at each reading of each track: the largest forward and the largest
// turning command of the last second, as sizes, so that what follows a command belongs to it.
struct RecentCommands {
  std::vector<std::vector<double>> forward_m_s;
  std::vector<std::vector<double>> turning_rad_s;
};
RecentCommands recent_commands(const FitProblem& problem, std::span<const ResidualTrack* const> tracks);

}  // namespace wheelwright::gap

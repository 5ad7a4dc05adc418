// How large the gap is in figures that a person knows, and how large it would be if only noise were left.
#pragma once

#include <span>

#include "model/gap/fit/fit_problem.hpp"
#include "model/log/drive_log.hpp"
#include "model/prediction/score.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

// The score of a model's free run over all logs.
Score gap_size(const RobotModel& model, std::span<const DriveLog> logs);

// The same where nobody knew that counts were lost: the travel of those that stood still counts as none.
Score gap_size_with_lost_counts(const RobotModel& model, std::span<const DriveLog> logs);

// The score that the same runs would have if the model were right: its free run with the noise that was
// found, drawn from `seed`, against itself without.
Score noise_floor(const RobotModel& model, std::span<const DriveLog> logs, const NoiseModel& noise,
                  std::uint64_t seed);

// The noise of a problem with what its runs drift over seconds under a model: from reading to reading, what
// drifts for a tenth of a second looks smoother than it is. Judged by readings half a second apart, or by
// those and by readings two seconds apart.
constexpr double half_a_second_apart_s = 0.5;
constexpr double two_seconds_apart_s = 2.0;
NoiseModel with_slow_noise(const FitProblem& problem, const TrialModel& model, double max_apart_s);

}  // namespace wheelwright::gap

// A linear model of a robot from commands and reference poses alone, without encoder counts.
//
// What the body did between poses is compared with a free run. Both wheels share one response, but for a gain
// of each; how far the body turns for what its wheels do gives the wheel base. Noise and fit are those of the
// gap workflow.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/selection/search.hpp"
#include "model/identification/refusal.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::gap {

// A figure with its 95 % interval.
struct Estimate {
  double value = 0.0;
  ParameterInterval interval;
};

struct PoseFit {
  LinearModel linear_part;  // its wheel base is the one that was found
  Estimate left_gain;
  Estimate right_gain;
  Estimate lag_s;  // by which the poses are behind what was commanded: delay, motors, and the reference's own
  Estimate wheel_base_m;
  double given_wheel_base_m = 0.0;
  std::size_t poses = 0;
  double pose_noise_m = 0.0;        // of one reading
  double drift_m_per_sqrt_s = 0.0;  // random walk of the body's travel

  WheelFit wheel_fit(const Estimate& gain, bool left) const;
};

// Whether these runs hold poses and no counts.
bool hold_poses_alone(std::span<const DriveLog> logs);

// Refuses, with the reason, where the runs do not show gains, lag or wheel base to within a half.
tl::expected<PoseFit, Refusal> fit_from_poses(std::span<const DriveLog> logs, const ParallelFor& parallel_for,
                                              const Progress& progress);

}  // namespace wheelwright::gap

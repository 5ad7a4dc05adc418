// How far the counts of recorded runs and a model's free run part: the noise figures that a filter by that
// model needs (filter/filter_noise.hpp).
//
// With r the travel counted less the travel predicted, m the travel predicted, over windows of 0.1 s and of 2
// s in which the wheel rolls (mean square D of dr - g dm), for each wheel,
//
//   gain error g = sum dm dr / sum dm^2 over the long windows, its standard error from their scatter,
//   D(t)         = 2 R + drift^2 t,    R: variance of one reading,
//
// which two lengths of t solve. A part of R is the age of a polled counter, which
// FilterNoise::refresh_period_s accounts for; position_noise is what is left of it.
#pragma once

#include <optional>
#include <span>

#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"
#include "model/simulation/wheel_fit.hpp"

namespace wheelwright {

struct WheelFits {
  WheelFit left;
  WheelFit right;
};

// Nothing where the runs hold no counts, or a wheel rolls for less than a minute.
std::optional<WheelFits> wheel_misfit(const RobotModel& model, std::span<const DriveLog> runs);

}  // namespace wheelwright

// How a measurement follows what it measures: late by one delay, or spread over several, as filters spread
// it.
//
//   shown(t) = sum_j weights[j] true(t - first_s - j step_s)
//
// A reference pose is filtered in the frame of its room, x, y and heading each by itself: an arc is shown
// with a smaller radius than it was driven.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/geometry/pose.hpp"

namespace wheelwright {

struct DelayKernel {
  double first_s = 0.0;         // delay of the first weight; negative where a filter looks ahead
  double step_s = 0.0;          // between two of them
  std::vector<double> weights;  // their sum is 1; none where what is shown is what is true

  double mean_s() const;
  double width_s() const;      // standard deviation about the mean; 0 where negative weights outweigh
  double rise_time_s() const;  // from 10 to 90 % of a step
};

// Of a reference's x and y, and of its heading.
struct ReferenceResponse {
  DelayKernel position;
  DelayKernel heading;

  bool is_immediate() const { return position.weights.empty() && heading.weights.empty(); }
};

// Poses at the times 0, period_s, 2 period_s, ... as a reference shows them then. Before the first and behind
// the last one the robot is taken to rest.
std::vector<Pose> shown_by(const ReferenceResponse& response, std::span<const Pose> poses, double period_s);

// What is shown at `t_s` of what is true at any time.
template <typename Value, typename ValueAt>
Value filtered(const DelayKernel& kernel, double t_s, ValueAt value_at) {
  if (kernel.weights.empty()) return value_at(t_s);
  Value shown = kernel.weights.front() * value_at(t_s - kernel.first_s);
  for (std::size_t j = 1; j < kernel.weights.size(); ++j)
    shown += kernel.weights[j] * value_at(t_s - kernel.first_s - static_cast<double>(j) * kernel.step_s);
  return shown;
}

// The pose that a reference shows at `t_s`, of `pose_at(t)`, the pose at any time.
template <typename PoseAt>
Pose shown_at(const ReferenceResponse& response, double t_s, PoseAt pose_at) {
  if (response.is_immediate()) return pose_at(t_s);
  return {filtered<double>(response.position, t_s, [&](double when_s) { return pose_at(when_s).x_m; }),
          filtered<double>(response.position, t_s, [&](double when_s) { return pose_at(when_s).y_m; }),
          filtered<double>(response.heading, t_s, [&](double when_s) { return pose_at(when_s).theta_rad; })};
}

}  // namespace wheelwright

#include "model/gap/fit/path_motion.hpp"

#include <algorithm>

namespace wheelwright::gap {
namespace {

// The pose after the steps between two grid times, seen from the one before them.
Pose passed(const std::vector<OdometryStep>& steps, const GridTime& from, const GridTime& to) {
  Pose pose;
  for_each_period(from, to, [&](std::size_t k, double share) {
    if (k < steps.size()) pose = move_along_arc(pose, {steps[k].forward_m, steps[k].turn_rad}, share);
  });
  return pose;
}

// The steps of a run as the poses that its references show, at each grid point.
std::vector<Pose> shown_path(const GapRun& run, const std::vector<OdometryStep>& steps,
                             const ModelSimulation* measured_by) {
  std::vector<Pose> poses;
  poses.reserve(steps.size() + 1);
  Pose pose;
  const auto add = [&] { poses.push_back(measured_by == nullptr ? pose : measured_by->observed(pose)); };
  add();
  for (const OdometryStep& step : steps) {
    pose = move_along_arc(pose, {step.forward_m, step.turn_rad}, 1.0);
    add();
  }
  return shown_by(run.reference_response, poses, run.period_s);
}

}  // namespace

Increment increment(const Pose& from, const Pose& to) {
  const double middle = 0.5 * (from.theta_rad + to.theta_rad);
  const double dx = to.x_m - from.x_m;
  const double dy = to.y_m - from.y_m;
  const auto [c, s] = direction_of(middle);
  return {c * dx + s * dy, -s * dx + c * dy, to.theta_rad - from.theta_rad};
}

PathMotion::PathMotion(const GapRun& run, const std::vector<OdometryStep>& steps,
                       const ModelSimulation* measured_by)
    : steps_(steps), measured_by_(measured_by) {
  if (!run.reference_response.is_immediate()) shown_ = shown_path(run, steps, measured_by);
}

Increment PathMotion::increment(const GridTime& from, const GridTime& to) const {
  if (!shown_.empty()) return wheelwright::gap::increment(shown_at(from), shown_at(to));
  const Pose motion = passed(steps_, from, to);
  if (measured_by_ == nullptr) return wheelwright::gap::increment({}, motion);
  return wheelwright::gap::increment(measured_by_->observed({}), measured_by_->observed(motion));
}

Pose PathMotion::shown_at(const GridTime& when) const {
  const Pose& a = shown_[std::min(when.period, shown_.size() - 1)];
  const Pose& b = shown_[std::min(when.period + 1, shown_.size() - 1)];
  return {interpolated(a.x_m, b.x_m, when.share), interpolated(a.y_m, b.y_m, when.share),
          interpolated(a.theta_rad, b.theta_rad, when.share)};
}

}  // namespace wheelwright::gap

#include "model/log/counted_windows.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "model/statistics/dense_solve.hpp"

namespace wheelwright {
namespace {

constexpr double least_between_s = 0.02;  // references that are nearer say the same
constexpr std::size_t least_references = 20;

std::vector<ShownPose> shown_poses(const DriveLog& run, const CountedPath& path) {
  std::vector<ShownPose> shown;
  double beyond_counts_rad = 0.0;
  for (const DriveSample& sample : run.samples) {
    if (!sample.reference_theta_rad) continue;
    if (!shown.empty() && sample.t_s - shown.back().t_s < least_between_s) continue;
    const double counted_rad = path.at(sample.t_s).theta_rad;
    beyond_counts_rad += wrap_angle(*sample.reference_theta_rad - counted_rad - beyond_counts_rad);
    shown.push_back({sample.t_s,
                     {sample.reference_x_m.value_or(0.0), sample.reference_y_m.value_or(0.0),
                      counted_rad + beyond_counts_rad},
                     sample.reference_pose().has_value()});
  }
  return shown;
}

Direction direction_in_frame(const CountedWindow& window) {
  using Point = std::complex<double>;
  const auto counted_at = [&](const ShownPose& shown) {
    const Pose pose = window.path.at(shown.t_s);
    return Point(pose.x_m, pose.y_m);
  };
  Point mean_shown = 0.0;
  Point mean_counted = 0.0;
  for (const ShownPose& shown : window.shown) {
    mean_shown += Point(shown.pose.x_m, shown.pose.y_m);
    mean_counted += counted_at(shown);
  }
  const auto count = static_cast<double>(window.shown.size());
  Point sum = 0.0;
  for (const ShownPose& shown : window.shown) {
    sum += (Point(shown.pose.x_m, shown.pose.y_m) - mean_shown / count) *
           std::conj(counted_at(shown) - mean_counted / count);
  }
  return direction_of(std::arg(sum));
}

Eigen::Vector2d quarter_turn(const Eigen::Vector2d& v) {
  return {-v.y(), v.x()};
}

}  // namespace

CountedPath::CountedPath(const DriveLog& run) {
  std::optional<WheelTicks> before;
  for (const DriveSample& sample : run.samples) {
    if (!sample.ticks) continue;
    Pose now = pose_.empty() ? Pose{} : pose_.back();
    Eigen::Vector2d weighted = weighted_.empty() ? Eigen::Vector2d(0.0, 0.0) : weighted_.back();
    if (before && sample.counter_reset) lost_s_.push_back(sample.t_s);
    if (before && !sample.counter_reset) {
      const double left = static_cast<double>(sample.ticks->left - before->left) * run.metres_per_tick->left;
      const double right =
          static_cast<double>(sample.ticks->right - before->right) * run.metres_per_tick->right;
      const Pose from = now;
      now = move_along_arc(now, twist_of_wheels({left, right}, run.wheel_base_m), 1.0);
      weighted +=
          0.5 * (from.theta_rad + now.theta_rad) * Eigen::Vector2d(now.x_m - from.x_m, now.y_m - from.y_m);
    }
    t_s_.push_back(sample.t_s);
    pose_.push_back(now);
    weighted_.push_back(weighted);
    before = sample.ticks;
  }
}

std::pair<std::size_t, double> CountedPath::place(double t_s) const {
  const auto after = std::ranges::upper_bound(t_s_, t_s);
  if (after == t_s_.begin()) return {0, 0.0};
  if (after == t_s_.end()) return {t_s_.size() - 1, 0.0};
  const auto i = static_cast<std::size_t>(after - t_s_.begin());
  return {i - 1, (t_s - t_s_[i - 1]) / (t_s_[i] - t_s_[i - 1])};
}

Pose CountedPath::at(double t_s) const {
  if (t_s_.empty()) return {};
  const auto [i, share] = place(t_s);
  const Pose& a = pose_[i];
  if (share == 0.0) return a;
  const Pose& b = pose_[i + 1];
  return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m),
          a.theta_rad + share * (b.theta_rad - a.theta_rad)};
}

Eigen::Vector2d CountedPath::weighted_at(double t_s) const {
  if (t_s_.empty()) return Eigen::Vector2d::Zero();
  const auto [i, share] = place(t_s);
  if (share == 0.0) return weighted_[i];
  return weighted_[i] + share * (weighted_[i + 1] - weighted_[i]);
}

bool CountedPath::covers(double from_s, double to_s) const {
  if (t_s_.size() < 2 || to_s > t_s_.back()) return false;
  return std::ranges::none_of(lost_s_, [&](double lost_s) { return lost_s > from_s && lost_s <= to_s; });
}

void for_each_window(std::span<const DriveLog* const> runs, double before_s, double after_s,
                     const std::function<void(const CountedWindow&)>& job) {
  for (const DriveLog* run : runs) {
    if (!run->metres_per_tick) continue;
    const CountedPath path(*run);
    const std::vector<ShownPose> shown = shown_poses(*run, path);
    for (auto begin = shown.begin(); begin != shown.end();) {
      const auto end = std::find_if(begin, shown.end(), [&](const ShownPose& each) {
        return each.t_s > begin->t_s + counted_window_s || each.has_position != begin->has_position;
      });
      const std::span<const ShownPose> window(begin, end);
      begin = end;
      const double from_s = window.front().t_s;
      const double to_s = window.back().t_s;
      if (window.size() < least_references || to_s - from_s < 0.5 * counted_window_s) continue;
      if (path.covers(from_s - before_s, to_s + after_s)) job({path, window});
    }
  }
}

PathInFrame::PathInFrame(const CountedWindow& window)
    : path_(window.path),
      origin_(window.path.at(window.shown.front().t_s)),
      weighted_origin_(window.path.weighted_at(window.shown.front().t_s)),
      turned_(direction_in_frame(window)) {}

Eigen::Vector2d PathInFrame::at(double t_s) const {
  const Pose pose = path_.at(t_s);
  return in_frame(pose.x_m - origin_.x_m, pose.y_m - origin_.y_m);
}

Eigen::Vector2d PathInFrame::weighted_at(double t_s) const {
  const Eigen::Vector2d weighted = path_.weighted_at(t_s) - weighted_origin_;
  return in_frame(weighted.x(), weighted.y());
}

Eigen::MatrixXd drift_of_position(const CountedWindow& window, const PathInFrame& path) {
  Eigen::MatrixXd drift = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(2 * window.shown.size()), 8);
  Eigen::Index row = 0;
  for (const ShownPose& shown : window.shown) {
    drift.block<2, 2>(row, 0).setIdentity();
    drift.block<2, 2>(row, 2) = (shown.t_s - window.shown.front().t_s) * Eigen::Matrix2d::Identity();
    drift.block<2, 1>(row, 4) = quarter_turn(path.at(shown.t_s));
    drift.block<2, 1>(row, 5) = quarter_turn(path.weighted_at(shown.t_s));
    const Direction heading = direction_of(shown.pose.theta_rad);
    drift.block<2, 1>(row, 6) << heading.cosine, heading.sine;
    drift.block<2, 1>(row, 7) << -heading.sine, heading.cosine;
    row += 2;
  }
  return drift;
}

Eigen::MatrixXd drift_of_heading(const CountedWindow& window) {
  Eigen::MatrixXd drift(static_cast<Eigen::Index>(window.shown.size()), 2);
  Eigen::Index row = 0;
  for (const ShownPose& shown : window.shown) drift.row(row++) << 1.0, shown.t_s - window.shown.front().t_s;
  return drift;
}

Eigen::MatrixXd products_beside(const Eigen::MatrixXd& left_out, const Eigen::MatrixXd& columns) {
  const Eigen::MatrixXd rest = rest_beside(left_out, columns);
  return rest.transpose() * rest;
}

}  // namespace wheelwright

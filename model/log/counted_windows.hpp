// Windows of four seconds, over which the poses of a reference are compared with the path by the counts.
//
// In a window the reference's x and y are the path by the counts, turned into the reference's frame, and
//
//   c0 + c1 t + c2 J p(t) + c3 J a(t) + R(theta) c4,   a(t) = integral of theta dp,
//
// with the path p and a quarter turn J: c1 is a floor on which the robot creeps, c2 and c3 a direction and a
// turn that the counts have wrong, c4 a lever arm. Its heading is that of the counts and c0 + c1 t. These c
// are of each window, and taken out of what is compared.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "model/geometry/pose.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright {

constexpr double counted_window_s = 4.0;
constexpr std::size_t least_counted_windows = 10;  // for standard errors by their scatter

// Of the middle of the axle, from the origin on.
class CountedPath {
 public:
  explicit CountedPath(const DriveLog& run);
  // Between two rows on a straight line; at rest before the first one and behind the last one.
  Pose at(double t_s) const;
  Eigen::Vector2d weighted_at(double t_s) const;  // a(t)
  // Whether there are counts until the later of two times, and none were lost between them.
  bool covers(double from_s, double to_s) const;

 private:
  std::pair<std::size_t, double> place(double t_s) const;

  std::vector<double> t_s_;
  std::vector<Pose> pose_;
  std::vector<Eigen::Vector2d> weighted_;
  std::vector<double> lost_s_;
};

struct ShownPose {
  double t_s;
  Pose pose;  // heading without jumps of a whole turn
  bool has_position;
};

struct CountedWindow {
  const CountedPath& path;
  std::span<const ShownPose> shown;  // at least twenty; all with a position, or none
};

// For each window of the runs whose counts are known from `before_s` before it until `after_s` behind it.
void for_each_window(std::span<const DriveLog* const> runs, double before_s, double after_s,
                     const std::function<void(const CountedWindow&)>& job);

// The path of a window from its first reference on, turned into the reference's frame.
class PathInFrame {
 public:
  explicit PathInFrame(const CountedWindow& window);
  Eigen::Vector2d at(double t_s) const;
  Eigen::Vector2d weighted_at(double t_s) const;

 private:
  Eigen::Vector2d in_frame(double x, double y) const {
    return {turned_.cosine * x - turned_.sine * y, turned_.sine * x + turned_.cosine * y};
  }

  const CountedPath& path_;
  Pose origin_;
  Eigen::Vector2d weighted_origin_;
  Direction turned_;
};

// Columns that the c multiply; of x and y two rows for each reference.
Eigen::MatrixXd drift_of_position(const CountedWindow& window, const PathInFrame& path);
Eigen::MatrixXd drift_of_heading(const CountedWindow& window);

// Products of all pairs of columns of `columns`, without what those of `left_out` explain.
Eigen::MatrixXd products_beside(const Eigen::MatrixXd& left_out, const Eigen::MatrixXd& columns);

}  // namespace wheelwright

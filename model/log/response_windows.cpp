#include "model/log/response_windows.hpp"

#include "model/log/counted_windows.hpp"

namespace wheelwright {
namespace {

using response_taps::delay_s;

WindowProducts tapped_heading(const CountedWindow& window) {
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(window.shown.size()), response_taps::count + 1);
  Eigen::Index row = 0;
  for (const ShownPose& shown : window.shown) {
    for (Eigen::Index j = 0; j < response_taps::count; ++j)
      columns(row, j) = window.path.at(shown.t_s - delay_s(j)).theta_rad;
    columns(row, response_taps::count) = shown.pose.theta_rad;
    ++row;
  }
  return products_beside(drift_of_heading(window), columns);
}

WindowProducts tapped_position(const CountedWindow& window) {
  const PathInFrame path(window);
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(2 * window.shown.size()), response_taps::count + 1);
  Eigen::Index row = 0;
  for (const ShownPose& shown : window.shown) {
    for (Eigen::Index j = 0; j < response_taps::count; ++j)
      columns.block<2, 1>(row, j) = path.at(shown.t_s - delay_s(j));
    columns.block<2, 1>(row, response_taps::count) = Eigen::Vector2d(shown.pose.x_m, shown.pose.y_m);
    row += 2;
  }
  return products_beside(drift_of_position(window, path), columns);
}

}  // namespace

ResponseWindows response_windows(std::span<const DriveLog* const> runs) {
  ResponseWindows windows;
  const double latest_s = delay_s(response_taps::count - 1);
  for_each_window(runs, latest_s, -response_taps::first_s, [&](const CountedWindow& window) {
    windows.heading.push_back(tapped_heading(window));
    if (window.shown.front().has_position) windows.position.push_back(tapped_position(window));
  });
  return windows;
}

}  // namespace wheelwright

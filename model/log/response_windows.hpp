// Sums of least squares for the response of a reference: in each window its x and y are
// sum_j h_j p(t - delay_j) of the path p by the counts, its heading sum_j h_j theta(t - delay_j), and what
// the window has of its own (counted_windows.hpp).
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "model/log/drive_log.hpp"

namespace wheelwright {

// The delays of the sums above.
namespace response_taps {
constexpr double first_s = -0.4;
constexpr double step_s = 0.04;
constexpr Eigen::Index count = 41;  // until 1.2 s
constexpr double delay_s(Eigen::Index tap) {
  return first_s + static_cast<double>(tap) * step_s;
}
}  // namespace response_taps

// Products of all pairs of columns over one window: one for each tap, and last what was measured.
using WindowProducts = Eigen::MatrixXd;

struct ResponseWindows {
  std::vector<WindowProducts> position;  // empty where the references have headings alone
  std::vector<WindowProducts> heading;
};

ResponseWindows response_windows(std::span<const DriveLog* const> runs);

}  // namespace wheelwright

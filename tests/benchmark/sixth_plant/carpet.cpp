#include "tests/benchmark/sixth_plant/carpet.hpp"

#include <algorithm>
#include <cmath>

#include "tests/benchmark/plants/exam.hpp"

namespace plants::sixth {

namespace {

double share_within(const Run& run, const Pose& middle, double half_x_m, double half_y_m) {
  const auto within = [&](const TrueRow& row) {
    return std::abs(row.reference_point.x_m - middle.x_m) < half_x_m &&
           std::abs(row.reference_point.y_m - middle.y_m) < half_y_m;
  };
  return static_cast<double>(std::ranges::count_if(run.truth, within)) /
         static_cast<double>(run.truth.size());
}

// How far from what is wanted.
double cost_of(const std::vector<Run>& runs, const Pose& middle, double half_m, double shape) {
  double least = 1;
  double most = 0;
  double mean = 0;
  for (const Run& run : runs) {
    const double share = share_within(run, middle, half_m, half_m * shape);
    least = std::min(least, share);
    most = std::max(most, share);
    mean += share / runs_of_a_case;
  }
  return std::abs(mean - 0.33) + 2 * std::max(0., 0.15 - least) + std::max(0., most - 0.6);
}

}  // namespace

void lay_carpet(Details& details, const std::vector<Run>& clean, Random& random) {
  constexpr int attempts = 200;
  double best = 1e9;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const auto& rows = clean[static_cast<std::size_t>(random.integer(0, runs_of_a_case - 1))].truth;
    const int last = static_cast<int>(rows.size()) - 1;
    const Pose middle = rows[static_cast<std::size_t>(random.integer(0, last))].reference_point;
    const double half_m = random.uniform(0.2, 0.45);
    const double cost = cost_of(clean, middle, half_m, details.patch_shape);
    if (cost >= best) continue;
    best = cost;
    details.patch_x_m = middle.x_m;
    details.patch_y_m = middle.y_m;
    details.patch_half_m = half_m;
  }
}

}  // namespace plants::sixth

#include "model/identification/run_scales.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelwright {
namespace {

constexpr double min_factor = 1.6;       // by which a run differs
constexpr double max_scatter = 1.2;      // by which the others may among themselves
constexpr double min_commanded_m = 0.3;  // of each wheel, to judge a run

// Travel by the counts for travel by the commands, without regard to direction; of the wheels that were
// driven.
struct RunScale {
  std::size_t run;
  double left;
  double right;
};

std::optional<RunScale> scale_of(const DriveLog& log, std::size_t run) {
  if (!log.has_ticks() || !log.metres_per_tick) return std::nullopt;
  double commanded_left_m = 0.0;
  double commanded_right_m = 0.0;
  double left_m = 0.0;
  double right_m = 0.0;
  const DriveSample* before = nullptr;
  for (const auto& sample : log.samples) {
    if (!sample.ticks) continue;
    if (before != nullptr) {
      const double duration_s = sample.t_s - before->t_s;
      commanded_left_m += std::abs(before->command_m_s.left) * duration_s;
      commanded_right_m += std::abs(before->command_m_s.right) * duration_s;
      left_m += std::abs(static_cast<double>(sample.ticks->left - before->ticks->left));
      right_m += std::abs(static_cast<double>(sample.ticks->right - before->ticks->right));
    }
    before = &sample;
  }
  if (commanded_left_m < min_commanded_m || commanded_right_m < min_commanded_m) return std::nullopt;
  const double left = left_m * log.metres_per_tick->left / commanded_left_m;
  const double right = right_m * log.metres_per_tick->right / commanded_right_m;
  if (!(left > 0.0) || !(right > 0.0)) return std::nullopt;
  return RunScale{run, left, right};
}

double mean_of(const RunScale& scale) {
  return std::sqrt(scale.left * scale.right);
}

}  // namespace

std::optional<ScaleOutlier> find_scale_outlier(std::span<const DriveLog> runs) {
  std::vector<RunScale> scales;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (const auto scale = scale_of(runs[run], run)) scales.push_back(*scale);
  }
  std::optional<ScaleOutlier> worst;
  for (const auto& candidate : scales) {
    std::vector<RunScale> others;
    for (const auto& other : scales) {
      if (other.run != candidate.run) others.push_back(other);
    }
    // Of two runs the later one is named against the first.
    if (others.empty() || (others.size() == 1 && others.front().run > candidate.run)) continue;
    const auto [low, high] = std::ranges::minmax_element(others, {}, mean_of);
    if (mean_of(*high) > max_scatter * mean_of(*low)) continue;
    const RunScale& other = others.front();
    const auto is_off = [](double factor) { return std::abs(std::log(factor)) > std::log(min_factor); };
    const double left = candidate.left / other.left;
    const double right = candidate.right / other.right;
    const double factor = std::sqrt(left * right);
    if (!is_off(left) || !is_off(right) || (left > 1.0) != (right > 1.0)) continue;
    if (!worst || std::abs(std::log(factor)) > std::abs(std::log(worst->factor)))
      worst = ScaleOutlier{candidate.run, factor, other.run};
  }
  return worst;
}

}  // namespace wheelwright

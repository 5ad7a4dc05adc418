#include "model/log/delay_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace wheelwright {
namespace {

// A kernel whose weights are whole periods apart.
struct GridKernel {
  std::ptrdiff_t first = 0;
  std::vector<double> weights{1.0};
};

GridKernel on_grid(const DelayKernel& kernel, double period_s) {
  if (kernel.weights.empty()) return {};
  const auto last = static_cast<double>(kernel.weights.size() - 1);
  const auto first = static_cast<std::ptrdiff_t>(std::floor(kernel.first_s / period_s));
  const auto end =
      static_cast<std::ptrdiff_t>(std::floor((kernel.first_s + last * kernel.step_s) / period_s)) + 1;
  GridKernel grid{first, std::vector<double>(static_cast<std::size_t>(end - first + 1), 0.0)};
  for (std::size_t j = 0; j < kernel.weights.size(); ++j) {
    const double delay = (kernel.first_s + static_cast<double>(j) * kernel.step_s) / period_s;
    const double whole = std::floor(delay);
    const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(whole) - first);
    grid.weights[at] += kernel.weights[j] * (1.0 - (delay - whole));
    grid.weights[at + 1] += kernel.weights[j] * (delay - whole);
  }
  return grid;
}

template <typename Add>
void for_each_weight(const GridKernel& kernel, std::size_t at, std::size_t count, Add add) {
  const auto last = static_cast<std::ptrdiff_t>(count) - 1;
  auto from = static_cast<std::ptrdiff_t>(at) - kernel.first;
  for (const double weight : kernel.weights) {
    add(weight, static_cast<std::size_t>(std::clamp(from, std::ptrdiff_t{0}, last)));
    --from;
  }
}

}  // namespace

double DelayKernel::mean_s() const {
  double mean = 0.0;
  for (std::size_t j = 0; j < weights.size(); ++j)
    mean += weights[j] * (first_s + static_cast<double>(j) * step_s);
  return mean;
}

double DelayKernel::width_s() const {
  const double mean = mean_s();
  double variance = 0.0;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const double apart_s = first_s + static_cast<double>(j) * step_s - mean;
    variance += weights[j] * apart_s * apart_s;
  }
  return std::sqrt(std::max(0.0, variance));
}

double DelayKernel::rise_time_s() const {
  const auto reaches_s = [&](double share) {
    double before = 0.0;
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const double sum = before + weights[j];
      if (sum >= share)
        return first_s + (static_cast<double>(j) - 1.0 + (share - before) / weights[j]) * step_s;
      before = sum;
    }
    return first_s + static_cast<double>(weights.size()) * step_s;
  };
  return weights.empty() ? 0.0 : reaches_s(0.9) - reaches_s(0.1);
}

std::vector<Pose> shown_by(const ReferenceResponse& response, std::span<const Pose> poses, double period_s) {
  const GridKernel position = on_grid(response.position, period_s);
  const GridKernel heading = on_grid(response.heading, period_s);
  std::vector<Pose> shown(poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    for_each_weight(position, k, poses.size(), [&](double weight, std::size_t from) {
      shown[k].x_m += weight * poses[from].x_m;
      shown[k].y_m += weight * poses[from].y_m;
    });
    for_each_weight(heading, k, poses.size(), [&](double weight, std::size_t from) {
      shown[k].theta_rad += weight * poses[from].theta_rad;
    });
  }
  return shown;
}

}  // namespace wheelwright

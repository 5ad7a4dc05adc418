#include "model/gap/linear_changes/command_correction.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
namespace {

constexpr double shortest_lag_s = 1e-3;

// Rest before the first command, the last one held after the last.
WheelPair command_at(std::span<const WheelPair> commands, std::ptrdiff_t period) {
  if (period < 0 || commands.empty()) return {};
  return commands[static_cast<std::size_t>(std::min(period, std::ssize(commands) - 1))];
}

// Times scale (1 - pole z^-1).
std::vector<double> times(const std::vector<double>& weights, double scale, double pole) {
  if (weights.empty()) return {};
  std::vector<double> product(weights.size() + 1, 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    product[i] += scale * weights[i];
    product[i + 1] -= scale * pole * weights[i];
  }
  return product;
}

}  // namespace

LinearModel corrected(const LinearModel& model, const CommandCorrection& correction) {
  const double lag_s = lag_of(model);
  const double old_pole = std::exp(-model.period_s / std::max(lag_s, shortest_lag_s));
  const double new_pole = std::exp(-model.period_s / std::max(lag_s + correction.lag_s, shortest_lag_s));
  const double scale = (1.0 - new_pole) / (1.0 - old_pole);
  LinearModel result = model;
  const auto correct = [&](WheelResponse& response, double gain) {
    response.from_left = times(response.from_left, gain * scale, old_pole);
    response.from_right = times(response.from_right, gain * scale, old_pole);
    std::vector<double> past{1.0};
    for (const double weight : response.from_own_past) past.push_back(-weight);
    past = times(past, 1.0, new_pole);
    response.from_own_past.clear();
    for (std::size_t i = 1; i < past.size(); ++i) response.from_own_past.push_back(-past[i]);
  };
  correct(result.left, correction.gain.left);
  correct(result.right, correction.gain.right);
  result.type = ModelType::arma;
  return result;
}

std::vector<WheelPair> delayed(std::span<const WheelPair> commands, double delay_s, double period_s) {
  const double shift = delay_s / period_s;
  const double whole = std::floor(shift);
  const double share = shift - whole;
  std::vector<WheelPair> result;
  result.reserve(commands.size());
  for (std::ptrdiff_t k = 0; k < std::ssize(commands); ++k) {
    const WheelPair late = command_at(commands, k - static_cast<std::ptrdiff_t>(whole));
    const WheelPair later = command_at(commands, k - static_cast<std::ptrdiff_t>(whole) - 1);
    result.push_back(
        {(1.0 - share) * late.left + share * later.left, (1.0 - share) * late.right + share * later.right});
  }
  return result;
}

double lag_of(const LinearModel& model) {
  constexpr double horizon_s = 5.0;
  LinearPredictor predictor(model);
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  const auto count = static_cast<int>(horizon_s / model.period_s);
  for (int k = 0; k < count; ++k) {
    const WheelPair speed = predictor.step(k == 0 ? WheelPair{1.0, 1.0} : WheelPair{});
    const double weight = speed.left + speed.right;
    const double t = model.period_s * k;
    sum += weight;
    first += weight * t;
    second += weight * t * t;
  }
  if (sum == 0.0) return model.period_s;
  const double mean = first / sum;
  const double variance = second / sum - mean * mean;
  return std::sqrt(std::max(variance, model.period_s * model.period_s));
}

}  // namespace wheelwright::gap

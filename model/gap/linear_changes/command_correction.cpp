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

}  // namespace

std::vector<WheelPair> corrected(std::span<const WheelPair> commands, const CommandCorrection& correction,
                                 double period_s, double model_lag_s) {
  const double shift = correction.delay_s / period_s;
  const double whole = std::floor(shift);
  const double share = shift - whole;
  const double old_pole = std::exp(-period_s / std::max(model_lag_s, shortest_lag_s));
  const double new_pole = std::exp(-period_s / std::max(model_lag_s + correction.lag_s, shortest_lag_s));
  const double scale = (1.0 - new_pole) / (1.0 - old_pole);
  std::vector<WheelPair> result;
  result.reserve(commands.size());
  WheelPair input_before{};
  WheelPair output{};
  for (std::ptrdiff_t k = 0; k < std::ssize(commands); ++k) {
    const WheelPair late = command_at(commands, k - static_cast<std::ptrdiff_t>(whole));
    const WheelPair later = command_at(commands, k - static_cast<std::ptrdiff_t>(whole) - 1);
    const auto next = [&](double WheelPair::*side) {
      const double input = correction.gain.*side * ((1.0 - share) * late.*side + share * later.*side);
      output.*side = new_pole * output.*side + scale * (input - old_pole * input_before.*side);
      input_before.*side = input;
    };
    next(&WheelPair::left);
    next(&WheelPair::right);
    result.push_back(output);
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

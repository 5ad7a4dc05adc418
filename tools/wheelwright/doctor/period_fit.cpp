#include "tools/wheelwright/doctor/period_fit.hpp"

#include <algorithm>
#include <cmath>

#include "model/statistics/confidence.hpp"

namespace wheelwright::tools::doctor {
namespace {

constexpr std::size_t min_frames = 10;

double quantile(const std::vector<double>& sorted, double share) {
  const auto rank = std::ceil(share * static_cast<double>(sorted.size())) - 1.0;
  return sorted[static_cast<std::size_t>(std::max(rank, 0.0))];
}

// Correlation of each residual with the next: an adapter that hands data on by its own timer beats slowly
// against the robot's period, and such residuals say less than their number.
double neighbour_correlation(const std::vector<double>& residuals, double sum_of_squares) {
  if (sum_of_squares <= 0.0) return 0.0;
  double products = 0.0;
  for (std::size_t i = 1; i < residuals.size(); ++i) products += residuals[i - 1] * residuals[i];
  return std::clamp(products / sum_of_squares, 0.0, 0.98);
}

}  // namespace

Spread spread_of(std::vector<double> durations_s) {
  if (durations_s.empty()) return {};
  std::sort(durations_s.begin(), durations_s.end());
  return {quantile(durations_s, 0.5), quantile(durations_s, 0.99), durations_s.back()};
}

std::optional<PeriodFit> fit_period(std::span<const FrameArrival> arrivals) {
  const auto count = static_cast<double>(arrivals.size());
  if (arrivals.size() < min_frames) return std::nullopt;
  double mean_number = 0.0;
  double mean_time_s = 0.0;
  for (const auto& arrival : arrivals) {
    mean_number += static_cast<double>(arrival.number) / count;
    mean_time_s += arrival.time_s / count;
  }
  double number_squares = 0.0;
  double products = 0.0;
  for (const auto& arrival : arrivals) {
    const double number = static_cast<double>(arrival.number) - mean_number;
    number_squares += number * number;
    products += number * (arrival.time_s - mean_time_s);
  }
  if (number_squares <= 0.0) return std::nullopt;
  PeriodFit fit;
  fit.period_s = products / number_squares;

  std::vector<double> residuals;
  residuals.reserve(arrivals.size());
  double sum_of_squares = 0.0;
  for (const auto& arrival : arrivals) {
    const double beat_s = mean_time_s + fit.period_s * (static_cast<double>(arrival.number) - mean_number);
    residuals.push_back(arrival.time_s - beat_s);
    sum_of_squares += residuals.back() * residuals.back();
  }
  const double correlation = neighbour_correlation(residuals, sum_of_squares);
  const double variance = sum_of_squares / (count - 2.0) * (1.0 + correlation) / (1.0 - correlation);
  fit.uncertainty_s = deviations_in_ci95 * std::sqrt(variance / number_squares);
  for (double& residual : residuals) residual = std::abs(residual);
  fit.jitter = spread_of(std::move(residuals));
  return fit;
}

}  // namespace wheelwright::tools::doctor

#include "tools/wheelwright/evaluation/offset_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace wheelwright::tools {
namespace {

constexpr int resamples = 4000;
constexpr double normal_quantile_975 = 1.959963984540054;

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(std::span<const double> values) {
  const double centre = mean(values);
  double square_sum = 0.0;
  for (const double value : values) square_sum += (value - centre) * (value - centre);
  return std::sqrt(square_sum / static_cast<double>(values.size() - 1));
}

using Statistic = double (*)(std::span<const double>);

double normal_probability(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

double normal_quantile(double probability) {
  double low = -9.0;
  double high = 9.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (normal_probability(middle) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// How fast the figure's standard error changes with the figure: a sixth of the jackknife's skewness.
double acceleration(std::span<const double> values, Statistic figure) {
  std::vector<double> without_one;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<double> rest(values.begin(), values.end());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    without_one.push_back(figure(rest));
  }
  const double centre = mean(without_one);
  double sum_squares = 0.0;
  double cubes = 0.0;
  for (const double value : without_one) {
    sum_squares += std::pow(centre - value, 2);
    cubes += std::pow(centre - value, 3);
  }
  return sum_squares > 0.0 ? cubes / (6.0 * std::pow(sum_squares, 1.5)) : 0.0;
}

std::optional<Interval> bootstrap_interval(std::span<const double> values, Statistic figure,
                                           std::uint64_t seed) {
  if (values.size() < 3) return std::nullopt;
  const double estimate = figure(values);
  std::mt19937_64 random(seed);
  std::vector<double> drawn(values.size());
  std::vector<double> replicates;
  replicates.reserve(resamples);
  for (int i = 0; i < resamples; ++i) {
    // By remainder, since the distributions of the standard library differ between libraries.
    for (double& value : drawn) value = values[random() % values.size()];
    replicates.push_back(figure(drawn));
  }
  std::sort(replicates.begin(), replicates.end());
  const auto below = std::lower_bound(replicates.begin(), replicates.end(), estimate) - replicates.begin();
  const double share = std::clamp((static_cast<double>(below) + 0.5) / (resamples + 1.0), 1e-6, 1.0 - 1e-6);
  const double bias = normal_quantile(share);
  const double slope = acceleration(values, figure);
  const auto bound = [&](double z) {
    const double place = normal_probability(bias + (bias + z) / (1.0 - slope * (bias + z)));
    return replicates[static_cast<std::size_t>(std::clamp(place * resamples, 0.0, resamples - 1.0))];
  };
  return Interval{bound(-normal_quantile_975), bound(normal_quantile_975)};
}

}  // namespace

OffsetStatistics offset_statistics(std::span<const double> offsets_m, std::uint64_t seed) {
  OffsetStatistics statistics;
  statistics.mean_m = mean(offsets_m);
  if (offsets_m.size() >= 2) statistics.standard_deviation_m = standard_deviation(offsets_m);
  statistics.mean_ci95_m = bootstrap_interval(offsets_m, mean, seed);
  statistics.standard_deviation_ci95_m = bootstrap_interval(offsets_m, standard_deviation, seed);
  return statistics;
}

}  // namespace wheelwright::tools

#include "tools/wheelwright/import/conversion/stamps.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::import {
namespace {

constexpr std::size_t fewest_rows = 50;
constexpr double hole_in_steps = 5.0;        // a longer step than so many is a hole
constexpr double uneven_from = 2.0;          // ratio of the percentiles 95 and 5 of the steps
constexpr double most_apart_in_steps = 3.0;  // stamps from even times
constexpr std::size_t half_window = 4;       // rows on each side that tell the speed at a row
// By how much the travel has to go by rows rather than by stamps: ratio of the sums of squares.
constexpr double smoother_by = 0.5;

double percentile(std::vector<double> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Sum of squares of the steps of travel beyond what the speed around each row explains over `durations`.
double roughness(std::span<const double> travel, std::span<const double> t_s) {
  double sum = 0.0;
  for (std::size_t i = half_window + 1; i + half_window < travel.size(); ++i) {
    const double around = travel[i + half_window] - travel[i - half_window - 1];
    const double duration_s = t_s[i + half_window] - t_s[i - half_window - 1];
    const double rest = travel[i] - travel[i - 1] - around / duration_s * (t_s[i] - t_s[i - 1]);
    if (std::isfinite(rest)) sum += rest * rest;
  }
  return sum;
}

// A straight line through the stamps of each part between holes; empty where the stamps stray from it.
std::vector<double> straighten(std::span<const double> t_s, double step_s) {
  std::vector<double> even(t_s.begin(), t_s.end());
  std::size_t begin = 0;
  while (begin < t_s.size()) {
    std::size_t end = begin + 1;
    while (end < t_s.size() && t_s[end] - t_s[end - 1] < hole_in_steps * step_s) ++end;
    const auto count = static_cast<double>(end - begin);
    double mean_t = 0.0;
    for (std::size_t i = begin; i < end; ++i) mean_t += t_s[i] / count;
    const double middle = 0.5 * (count - 1.0);
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double k = static_cast<double>(i - begin) - middle;
      products += k * (t_s[i] - mean_t);
      squares += k * k;
    }
    const double slope_s = squares > 0.0 ? products / squares : 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      even[i] = mean_t + slope_s * (static_cast<double>(i - begin) - middle);
      if (std::abs(even[i] - t_s[i]) > most_apart_in_steps * step_s) return {};
      if (i > 0 && even[i] <= even[i - 1]) return {};
    }
    begin = end;
  }
  return even;
}

}  // namespace

std::optional<EvenStamps> even_stamps(std::span<const double> t_s, std::span<const double> travel) {
  if (t_s.size() < fewest_rows || travel.size() != t_s.size()) return std::nullopt;
  std::vector<double> steps;
  for (std::size_t i = 1; i < t_s.size(); ++i) steps.push_back(t_s[i] - t_s[i - 1]);
  EvenStamps result;
  result.shortest_s = percentile(steps, 0.05);
  result.longest_s = percentile(steps, 0.95);
  if (result.longest_s < uneven_from * result.shortest_s) return std::nullopt;
  // Between holes; the median of steps in bunches says little, their mean does.
  const double median_s = percentile(steps, 0.5);
  double sum_s = 0.0;
  double count = 0.0;
  for (const double step : steps) {
    if (step > 2.0 * hole_in_steps * std::max(median_s, result.longest_s / hole_in_steps)) continue;
    sum_s += step;
    count += 1.0;
  }
  result.period_s = sum_s / count;
  result.t_s = straighten(t_s, result.period_s);
  if (result.t_s.empty()) return std::nullopt;
  if (roughness(travel, result.t_s) > smoother_by * roughness(travel, t_s)) return std::nullopt;
  return result;
}

}  // namespace wheelwright::import

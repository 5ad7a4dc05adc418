#include "tools/wheelwright/import/conversion/stamps.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t min_stamped_rows = 50;
constexpr double stamp_hole_in_steps = 5.0;  // a longer step than so many is a hole
constexpr double uneven_from = 2.0;          // ratio of the percentiles 95 and 5 of the steps
constexpr double max_apart_in_steps = 3.0;   // stamps from even times
constexpr std::size_t half_window = 4;       // rows on each side that tell the speed at a row
// By how much the travel has to go by rows rather than by stamps: ratio of the sums of squares.
constexpr double smoother_by = 0.5;

struct Roughness {
  double sum = 0.0;
  std::size_t count = 0;
};

// Sum of squares of the steps of travel beyond what the speed around each row explains over `durations`.
Roughness roughness(std::span<const double> travel, std::span<const double> t_s) {
  Roughness result;
  for (std::size_t i = half_window + 1; i + half_window < travel.size(); ++i) {
    const double context = travel[i + half_window] - travel[i - half_window - 1];
    const double duration_s = t_s[i + half_window] - t_s[i - half_window - 1];
    const double rest = travel[i] - travel[i - 1] - context / duration_s * (t_s[i] - t_s[i - 1]);
    if (!std::isfinite(rest)) continue;
    result.sum += rest * rest;
    ++result.count;
  }
  return result;
}

// A straight line through the stamps of each part between holes; empty where the stamps stray from it.
std::vector<double> straighten(std::span<const double> t_s, double step_s) {
  std::vector<double> even(t_s.begin(), t_s.end());
  std::size_t begin = 0;
  while (begin < t_s.size()) {
    std::size_t end = begin + 1;
    while (end < t_s.size() && t_s[end] - t_s[end - 1] < stamp_hole_in_steps * step_s) ++end;
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
      if (std::abs(even[i] - t_s[i]) > max_apart_in_steps * step_s) return {};
      if (i > 0 && even[i] <= even[i - 1]) return {};
    }
    begin = end;
  }
  return even;
}

}  // namespace

std::string EvenStamps::text() const {
  const auto milliseconds = [](double seconds, int decimals) {
    return config::fixed_number(1e3 * seconds, decimals) + " ms";
  };
  return "stamps come in bunches (5 % of the steps are below " + milliseconds(shortest_s, 1) +
         ", 5 % above " + milliseconds(longest_s, 1) +
         "), while the wheels turn evenly by rows; taken at even times, " + milliseconds(period_s, 2) +
         " apart";
}

std::optional<EvenStamps> even_stamps(std::span<const double> t_s, std::span<const double> travel) {
  if (t_s.size() < min_stamped_rows || travel.size() != t_s.size()) return std::nullopt;
  std::vector<double> steps;
  for (std::size_t i = 1; i < t_s.size(); ++i) steps.push_back(t_s[i] - t_s[i - 1]);
  EvenStamps result;
  result.shortest_s = quantile(steps, 0.05);
  result.longest_s = quantile(steps, 0.95);
  if (result.longest_s < uneven_from * result.shortest_s) return std::nullopt;
  // Between holes; the median of steps in bunches says little, their mean does.
  const double median_s = quantile(steps, 0.5);
  double sum_s = 0.0;
  double count = 0.0;
  for (const double step : steps) {
    if (step > 2.0 * stamp_hole_in_steps * std::max(median_s, result.longest_s / stamp_hole_in_steps))
      continue;
    sum_s += step;
    count += 1.0;
  }
  result.period_s = sum_s / count;
  result.t_s = straighten(t_s, result.period_s);
  if (result.t_s.empty()) return std::nullopt;
  const Roughness stamped = roughness(travel, t_s);
  const Roughness even = roughness(travel, result.t_s);
  // Rows without a measurement between those with one say nothing.
  if (2 * stamped.count < t_s.size() || !(stamped.sum > 0.0)) return std::nullopt;
  if (even.sum > smoother_by * stamped.sum) return std::nullopt;
  return result;
}

}  // namespace wheelwright::import

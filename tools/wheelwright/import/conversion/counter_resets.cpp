#include "tools/wheelwright/import/conversion/counter_resets.hpp"

#include <algorithm>
#include <cmath>

#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t min_steps = 20;
constexpr double far_steps = 10.0;  // of the usual large step, that the travel has at least before
constexpr double near_steps = 3.0;  // and at most behind it

// Percentile 95 of the sizes of the steps that are any.
double large_step(std::span<const double> travel, std::span<const std::size_t> filled) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < filled.size(); ++k) {
    const double step = std::abs(travel[filled[k]] - travel[filled[k - 1]]);
    if (step > 0.0) steps.push_back(step);
  }
  if (steps.size() < min_steps) return 0.0;
  return quantile(std::move(steps), 0.95);
}

// Most logs have no value that could begin again: they are not looked at further.
bool falls_towards_zero(std::span<const double> travel) {
  double last = 0.0;
  for (const double value : travel) {
    if (!std::isfinite(value)) continue;
    if (std::abs(value) < near_steps / far_steps * std::abs(last)) return true;
    last = value;
  }
  return false;
}

}  // namespace

std::vector<std::size_t> counter_resets(std::span<const double> travel) {
  std::vector<std::size_t> resets;
  if (!falls_towards_zero(travel)) return resets;
  std::vector<std::size_t> filled;
  for (std::size_t i = 0; i < travel.size(); ++i) {
    if (std::isfinite(travel[i])) filled.push_back(i);
  }
  const double step = large_step(travel, filled);
  if (!(step > 0.0) || wrapped_bits(travel)) return resets;
  for (std::size_t k = 1; k + 1 < filled.size(); ++k) {
    const double before = std::abs(travel[filled[k - 1]]);
    if (before > far_steps * step && std::abs(travel[filled[k]]) <= near_steps * step &&
        std::abs(travel[filled[k + 1]]) <= 2.0 * near_steps * step)
      resets.push_back(filled[k]);
  }
  return resets;
}

}  // namespace wheelwright::import

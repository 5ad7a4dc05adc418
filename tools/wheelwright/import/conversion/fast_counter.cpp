#include "tools/wheelwright/import/conversion/fast_counter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_lag = 4;
constexpr std::array smoothings{0.0, 0.3, 0.5, 0.65, 0.8, 0.9};
constexpr std::size_t max_rows = 2000;  // enough to decide
constexpr std::size_t min_rows = 50;
constexpr double max_turns = 4.0;  // of the counter in one row
constexpr double grid_turns = 0.05;
constexpr double apart_turns = 0.3;  // predictions that differ by less are one

std::vector<double> steps_of(std::span<const double> counts) {
  std::vector<double> steps(counts.size(), nothing);
  double last = nothing;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (std::isfinite(counts[i])) {
      steps[i] = counts[i] - last;
      last = counts[i];
    }
  }
  return steps;
}

// What a wheel does that follows its command after `lag` rows and comes nearer to it by a part in each.
std::vector<double> followed(std::span<const double> travel, std::size_t lag, double smoothing,
                             std::size_t rows) {
  std::vector<double> result(rows, nothing);
  double speed = 0.0;
  for (std::size_t i = lag; i < rows; ++i) {
    if (!std::isfinite(travel[i - lag])) continue;
    speed = smoothing * speed + (1.0 - smoothing) * travel[i - lag];
    result[i] = speed;
  }
  return result;
}

// How well the steps agree with the prediction on the circle of the counter. Rows at rest agree with any, and
// are left out.
double agreement_of(std::span<const double> steps, std::span<const double> travel, double modulus,
                    double gain) {
  std::complex<double> sum;
  double count = 0.0;
  for (std::size_t i = 0; i < travel.size(); ++i) {
    if (!std::isfinite(steps[i]) || !std::isfinite(travel[i]) || travel[i] == 0.0) continue;
    sum += std::polar(1.0, 2.0 * std::numbers::pi * (steps[i] - gain * travel[i]) / modulus);
    count += 1.0;
  }
  return count < static_cast<double>(min_rows) ? 0.0 : std::max(0.0, sum.real() / count);
}

}  // namespace

bool is_fast_counter(std::span<const double> counts, int bits) {
  const double modulus = std::ldexp(1.0, bits);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  for (const double count : counts) {
    if (!std::isfinite(count)) continue;
    if (count != std::round(count)) return false;
    lowest = std::min(lowest, count);
    highest = std::max(highest, count);
  }
  const bool fits = (lowest >= 0.0 && highest < modulus) || (lowest >= -modulus / 2 && highest < modulus / 2);
  if (!fits || highest - lowest < 0.95 * modulus) return false;
  std::size_t ambiguous = 0;
  std::size_t moving = 0;
  for (const double step : steps_of(counts)) {
    if (!std::isfinite(step) || step == 0.0) continue;
    ++moving;
    const double shortest = std::abs(step - modulus * std::round(step / modulus));
    if (shortest > 0.4 * modulus) ++ambiguous;
  }
  return moving > min_rows && 50 * ambiguous > moving;
}

CounterPrediction predict_counter(std::span<const double> counts, std::span<const double> travel, int bits,
                                  std::optional<double> counts_per_travel) {
  const double modulus = std::ldexp(1.0, bits);
  const std::vector<double> steps = steps_of(counts);
  double largest = 0.0;
  for (const double commanded : travel) {
    if (std::isfinite(commanded)) largest = std::max(largest, std::abs(commanded));
  }
  CounterPrediction best;
  if (!(largest > 0.0)) return best;
  const double unit = modulus / largest;  // the gain of one turn at the largest command
  struct Follower {
    std::size_t lag;
    double smoothing;
    std::vector<double> travel;
  };
  std::vector<Follower> followers;
  const std::size_t rows = std::min(counts.size(), max_rows);
  for (std::size_t lag = 0; lag <= max_lag; ++lag) {
    for (const double smoothing : smoothings)
      followers.push_back({lag, smoothing, followed(travel, lag, smoothing, rows)});
  }
  std::vector<CounterPrediction> tried;
  const auto attempt = [&](double gain) {
    CounterPrediction at{gain, 0, 0.0, -1.0, 0.0};
    for (const auto& follower : followers) {
      const double agreement = agreement_of(steps, follower.travel, modulus, gain);
      if (agreement > at.agreement) at = {gain, follower.lag, follower.smoothing, agreement, 0.0};
    }
    tried.push_back(at);
    if (at.agreement > best.agreement) best = at;
  };
  constexpr double near = 1.35;
  const double from = counts_per_travel ? *counts_per_travel / near / unit : grid_turns;
  const double until = counts_per_travel ? *counts_per_travel * near / unit : max_turns;
  for (double turns = from; turns <= until; turns += grid_turns) attempt(turns * unit);
  const double coarse = best.counts_per_travel;
  for (double part = -1.0; part <= 1.0; part += 0.05) attempt(coarse + part * grid_turns * unit);
  for (const auto& other : tried) {
    if (std::abs(other.counts_per_travel - best.counts_per_travel) > apart_turns * unit)
      best.next_agreement = std::max(best.next_agreement, other.agreement);
  }
  return best;
}

void unwrap_by_prediction(std::span<double> counts, std::span<const double> travel, int bits,
                          const CounterPrediction& prediction) {
  const double modulus = std::ldexp(1.0, bits);
  const std::vector<double> steps = steps_of(counts);
  const auto travelled = followed(travel, prediction.lag, prediction.smoothing, counts.size());
  double sum = nothing;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!std::isfinite(counts[i])) continue;
    if (!std::isfinite(steps[i])) {
      sum = counts[i];
      continue;
    }
    const double predicted = std::isfinite(travelled[i]) ? prediction.counts_per_travel * travelled[i] : 0.0;
    sum += steps[i] + modulus * std::round((predicted - steps[i]) / modulus);
    counts[i] = sum;
  }
}

}  // namespace wheelwright::import

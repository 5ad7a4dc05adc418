#include "model/gap/noise/noise_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheelwright::gap {
namespace {

// Log likelihood of the samples for a ratio of walk to reading noise, with their common size chosen at its
// best.
struct Profile {
  double log_likelihood;
  double size;  // by which both noises have to be multiplied
};

InnovationSums sums_of(std::span<const NoiseSample> samples, const TravelNoise& noise) {
  InnovationSums all;
  for (const auto& sample : samples) {
    const InnovationSums one =
        Whitener::sums(sample.times_s, sample.restarts, noise, sample.unsteady, sample.errors);
    all.sum_squares += one.sum_squares;
    all.log_determinant += one.log_determinant;
    all.count += one.count;
  }
  return all;
}

Profile profile(std::span<const NoiseSample> samples, const TravelNoise& shape) {
  const InnovationSums all = sums_of(samples, shape);
  if (all.count == 0) return {0.0, 1.0};
  const double n = static_cast<double>(all.count);
  const double variance = std::max(all.sum_squares / n, 1e-30);
  return {-0.5 * n * std::log(variance) - all.log_determinant, std::sqrt(variance)};
}

constexpr std::array lasting_s{
    0.03, 0.06, 0.12, motor_correlation_time_s, 0.5, oscillation_correlation_time_s};
constexpr std::array returning_s{1.0, 3.0, 10.0};
constexpr double default_tracker_s = 0.1;
constexpr std::array tracker_correlation_time_s{0.04, 0.2, 0.4};
constexpr std::array tracker_of_reading{0.7, 1.4, 3.0, 10.0};
constexpr std::array steady_shares{0.7, 0.5, 0.35, 0.25, 0.17, 0.12};
constexpr double worth_it_nats = 10.0;  // of a further number
constexpr std::array far_apart_s{0.5, 2.0};
constexpr double min_far_share = 0.85;  // of what is predicted for readings that lie far apart

// Walk in one second over reading noise, in steps of a quarter of a decade.
constexpr int steps = 24;
constexpr double smallest_ratio = 1e-3;
constexpr double largest_ratio = 1e3;

struct Shape {
  double step;
  TravelNoise noise;
  Profile profile;

  TravelNoise scaled() const {
    TravelNoise noise_here = noise;
    noise_here.reading *= profile.size;
    noise_here.walk_per_sqrt_s *= profile.size;
    noise_here.tracker *= profile.size;
    return noise_here;
  }
  bool likelier_than(const Shape& other, double by_nats = 0.0) const {
    return profile.log_likelihood > other.profile.log_likelihood + by_nats;
  }
};

Shape of_step(std::span<const NoiseSample> samples, TravelNoise noise, double step) {
  const double share = step / steps;
  noise.reading = 1.0;
  noise.walk_per_sqrt_s = smallest_ratio * std::pow(largest_ratio / smallest_ratio, share);
  return {step, noise, profile(samples, noise)};
}

Shape most_likely_walk(std::span<const NoiseSample> samples) {
  Shape best = of_step(samples, {}, 0);
  for (int step = 1; step <= steps; ++step) {
    const Shape found = of_step(samples, {}, step);
    if (found.likelier_than(best)) best = found;
  }
  return best;
}

// What lasts comes to more over a long time than a walk that looks like it from reading to reading: the
// nearest ratio that is best.
Shape climbed(std::span<const NoiseSample> samples, const TravelNoise& noise, double from_step) {
  Shape best = of_step(samples, noise, from_step);
  for (const int direction : {1, -1}) {
    for (double step = from_step + direction; step >= 0 && step <= steps; step += direction) {
      const Shape found = of_step(samples, noise, step);
      if (!found.likelier_than(best)) break;
      best = found;
    }
    if (best.step != from_step) break;
  }
  return best;
}

// Between the steps.
Shape refined(std::span<const NoiseSample> samples, const Shape& present) {
  Shape best = present;
  for (const double width : {0.5, 0.25, 0.125}) {
    const Shape context = best;
    for (const double step : {context.step - width, context.step + width}) {
      const Shape found = of_step(samples, context.noise, step);
      if (found.likelier_than(best)) best = found;
    }
  }
  return best;
}

Shape lasting(std::span<const NoiseSample> samples, const Shape& present, double longest_s) {
  Shape best = present;
  double step = present.step;
  for (const double drift_correlation_time_s : lasting_s) {
    if (drift_correlation_time_s > longest_s) break;
    TravelNoise noise = present.noise;
    noise.drift_correlation_time_s = drift_correlation_time_s;
    const Shape found = climbed(samples, noise, step);
    step = found.step;
    if (found.likelier_than(best, best.noise.drift_correlation_time_s == 0.0 ? worth_it_nats : 0.0))
      best = found;
  }
  return best;
}

Shape returning(std::span<const NoiseSample> samples, const Shape& present) {
  Shape best = present;
  for (const double return_time_s : returning_s) {
    TravelNoise noise = present.noise;
    noise.return_time_s = return_time_s;
    const Shape found = climbed(samples, noise, present.step);
    if (found.likelier_than(best, std::isinf(best.noise.return_time_s) ? worth_it_nats : 0.0)) best = found;
  }
  return best;
}

bool holds_between_far_readings(std::span<const NoiseSample> samples, const Shape& shape) {
  return std::ranges::all_of(far_apart_s, [&](double apart_s) {
    std::vector<ErrorSeries> series;
    series.reserve(samples.size());
    for (const auto& sample : samples) series.push_back(thinned(sample, apart_s));
    std::vector<NoiseSample> far;
    far.reserve(series.size());
    for (const auto& one : series) far.push_back(one.sample());
    return profile(far, shape.noise).size > min_far_share * shape.profile.size;
  });
}

Shape of_drift(std::span<const NoiseSample> samples, const Shape& walk, const NoiseLimits& limits) {
  Shape best = lasting(samples, walk, limits.max_correlation_time_s);
  const Shape returns = returning(samples, best);
  if (returns.noise.return_time_s != best.noise.return_time_s)
    best = lasting(samples, returns, limits.max_correlation_time_s);
  return !limits.tracked || holds_between_far_readings(samples, best) ? best : walk;
}

// So many readings of each that they tell what lasts for a part of a second.
std::vector<NoiseSample> begins_of(std::span<const NoiseSample> samples) {
  constexpr std::size_t max_readings = 6000;
  std::vector<NoiseSample> begins;
  begins.reserve(samples.size());
  for (const auto& [times_s, restarts, errors, unsteady] : samples) {
    const std::size_t count = std::min(times_s.size(), max_readings / samples.size());
    begins.push_back({times_s.first(count), restarts.first(count), errors.first(count),
                      unsteady.first(std::min(count, unsteady.size()))});
  }
  return begins;
}

// By what readings err alike, beside a walk. A walk has taken up what they err, so that the way to it leads
// from a smaller one.
Shape tracked(std::span<const NoiseSample> samples, const Shape& walk) {
  Shape best = walk;
  const auto consider = [&](double drift_correlation_time_s, double of_reading, double from_step) {
    TravelNoise noise = walk.noise;
    noise.tracker_correlation_time_s = drift_correlation_time_s;
    noise.tracker = of_reading;
    const Shape found = climbed(samples, noise, std::max(0.0, from_step));
    if (found.likelier_than(best, best.noise.tracker == 0.0 ? 2.0 * worth_it_nats : 0.0)) best = found;
  };
  for (const double of_reading : tracker_of_reading) {
    for (const double fewer : {0.0, 4.0, 8.0}) consider(default_tracker_s, of_reading, walk.step - fewer);
  }
  if (best.noise.tracker == 0.0) return best;
  const double of_reading = best.noise.tracker;
  for (const double drift_correlation_time_s : tracker_correlation_time_s)
    consider(drift_correlation_time_s, of_reading, best.step);
  const double drift_correlation_time_s = best.noise.tracker_correlation_time_s;
  for (const double more : {0.7, 1.4}) consider(drift_correlation_time_s, more * of_reading, best.step);
  return best;
}

bool has_both(std::span<const NoiseSample> samples) {
  constexpr double min_share = 0.1;
  double unsteady = 0.0;
  double all = 0.0;
  for (const auto& sample : samples) {
    for (const double share : sample.unsteady) unsteady += share;
    all += static_cast<double>(sample.times_s.size());
  }
  return unsteady > min_share * all && unsteady < (1.0 - min_share) * all;
}

// How much less it drifts where commands are steady.
Shape steadier(std::span<const NoiseSample> samples, const Shape& present) {
  if (!has_both(samples)) return present;
  Shape best = present;
  double step = present.step;
  for (const double share : steady_shares) {
    TravelNoise noise = present.noise;
    noise.steady_share = share;
    const Shape found = climbed(samples, noise, step);
    step = found.step;
    if (found.likelier_than(best, best.noise.steady_share == 1.0 ? worth_it_nats : 0.0)) best = found;
  }
  return best;
}

}  // namespace

ErrorSeries thinned(const NoiseSample& all, double min_apart_s) {
  ErrorSeries kept;
  bool restart = false;
  double unsteady_s = 0.0;  // since the last one that was kept
  for (std::size_t i = 0; i < all.times_s.size(); ++i) {
    restart = restart || all.restarts[i] != 0;
    if (i > 0 && !all.unsteady.empty()) unsteady_s += all.unsteady[i] * (all.times_s[i] - all.times_s[i - 1]);
    const double since_s = kept.times_s.empty() ? 0.0 : all.times_s[i] - kept.times_s.back();
    if (!restart && !kept.times_s.empty() && since_s < min_apart_s) continue;
    if (!all.unsteady.empty()) kept.unsteady.push_back(since_s > 0.0 ? unsteady_s / since_s : 0.0);
    unsteady_s = 0.0;
    kept.times_s.push_back(all.times_s[i]);
    kept.restarts.push_back(restart ? 1 : 0);
    kept.errors.push_back(all.errors[i]);
    restart = false;
  }
  return kept;
}

TravelNoise noise_of(std::span<const NoiseSample> samples, const NoiseLimits& limits) {
  const Shape walk = most_likely_walk(samples);
  Shape best = of_drift(samples, walk, limits);
  if (limits.tracked) {
    const auto begins = begins_of(samples);
    const Shape at_begin = tracked(begins, of_step(begins, walk.noise, walk.step));
    const Shape by_tracker = climbed(samples, at_begin.noise, at_begin.step);
    if (by_tracker.noise.tracker > 0.0 && by_tracker.likelier_than(best) &&
        holds_between_far_readings(samples, by_tracker))
      best = by_tracker;
  }
  TravelNoise noise = refined(samples, steadier(samples, best)).scaled();
  noise.reading = std::max(noise.reading, limits.smallest_reading);
  noise.walk_per_sqrt_s = std::max(noise.walk_per_sqrt_s, 1e-3 * limits.smallest_reading);
  return noise;
}

}  // namespace wheelwright::gap

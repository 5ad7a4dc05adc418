#include "model/gap/noise/whitening.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
// White noise drives a speed that decays at rate b, and that a travel that decays at rate a; the integrals
// are those of the squares and products of their impulse responses.
DriftStep::DriftStep(const TravelNoise& noise, double duration_s, double unsteady) {
  const double intensity = unsteady + (1.0 - unsteady) * noise.steady_share * noise.steady_share;
  const double walk2 = noise.walk_per_sqrt_s * noise.walk_per_sqrt_s * intensity;
  const double a = 1.0 / noise.returns_s;
  const auto integral = [duration_s](double rate) {
    return rate > 0.0 ? -std::expm1(-rate * duration_s) / rate : duration_s;
  };
  kept = std::exp(-a * duration_s);
  if (noise.lasts_s <= 0.0) {
    carry_s = decay = 0.0;
    travel_variance = walk2 * integral(2.0 * a);
    return;
  }
  constexpr double apart = 1e-4;  // two equal rates have integrals of their own, which these come near to
  double b = 1.0 / noise.lasts_s;
  if (std::abs(b - a) < apart * a) b = (1.0 + apart) * a;
  const double quicker = b / (b - a);
  decay = std::exp(-b * duration_s);
  carry_s = (kept - decay) / (b - a);
  travel_variance =
      walk2 * quicker * quicker * (integral(2.0 * a) - 2.0 * integral(a + b) + integral(2.0 * b));
  covariance = walk2 * b * quicker * (integral(a + b) - integral(2.0 * b));
  speed_variance = walk2 * b * b * integral(2.0 * b);
}

double drift_speed_variance(const TravelNoise& noise) {
  return noise.lasts_s > 0.0 ? noise.walk_per_sqrt_s * noise.walk_per_sqrt_s / (2.0 * noise.lasts_s) : 0.0;
}

double TravelNoise::tracker_kept(double duration_s) const {
  return tracker_lasts_s > 0.0 ? std::exp(-duration_s / tracker_lasts_s) : 0.0;
}

bool Whitener::Spread::as_good_as(const Spread& other) const {
  const auto close = [](double a, double b) {
    constexpr double relative = 1e-12;
    return std::abs(a - b) <= relative * std::abs(b);
  };
  return close(travel, other.travel) && close(travel_speed, other.travel_speed) &&
         close(speed, other.speed) && close(travel_tracker, other.travel_tracker) &&
         close(speed_tracker, other.speed_tracker) && close(tracker, other.tracker);
}

Whitener::Step Whitener::advance(Spread& spread, const DriftStep& drift, const TrackerStep& tracker,
                                 double reading) {
  const double ahead = drift.kept * spread.travel_speed + drift.carry_s * spread.speed;
  Spread expected{};
  expected.travel = drift.kept * (drift.kept * spread.travel + drift.carry_s * spread.travel_speed) +
                    drift.carry_s * ahead + drift.travel_variance;
  expected.travel_speed = drift.decay * ahead + drift.covariance;
  expected.speed = drift.decay * drift.decay * spread.speed + drift.speed_variance;
  expected.travel_tracker =
      tracker.kept * (drift.kept * spread.travel_tracker + drift.carry_s * spread.speed_tracker);
  expected.speed_tracker = tracker.kept * drift.decay * spread.speed_tracker;
  expected.tracker = tracker.kept * tracker.kept * spread.tracker + tracker.variance;

  const double with_travel = expected.travel + expected.travel_tracker;
  const double with_speed = expected.travel_speed + expected.speed_tracker;
  const double with_tracker = expected.travel_tracker + expected.tracker;
  const double innovation = with_travel + with_tracker + reading;
  const double gain = with_travel / innovation;
  const double speed_gain = with_speed / innovation;
  const double tracker_gain = with_tracker / innovation;
  spread = {expected.travel - gain * with_travel,
            expected.travel_speed - gain * with_speed,
            expected.speed - speed_gain * with_speed,
            expected.travel_tracker - gain * with_tracker,
            expected.speed_tracker - speed_gain * with_tracker,
            expected.tracker - tracker_gain * with_tracker};
  return {{drift.kept, drift.carry_s, tracker.kept, 0.0},
          {(1.0 - gain) * drift.kept, (1.0 - gain) * drift.carry_s, -gain * tracker.kept, gain},
          {-speed_gain * drift.kept, drift.decay - speed_gain * drift.carry_s, -speed_gain * tracker.kept,
           speed_gain},
          {-tracker_gain * drift.kept, -tracker_gain * drift.carry_s, (1.0 - tracker_gain) * tracker.kept,
           tracker_gain},
          1.0 / std::sqrt(innovation)};
}

Whitener::Whitener(std::span<const double> times_s, std::span<const char> restarts, const TravelNoise& noise,
                   std::span<const double> unsteady)
    : lasting_(noise.lasts_s > 0.0), tracked_(noise.tracker > 0.0) {
  const double reading = noise.reading * noise.reading;
  const double alike = noise.tracker * noise.tracker;
  DriftStep drift(noise, 0.0);
  TrackerStep tracker{1.0, 0.0};
  double duration_s = 0.0;
  double unsteady_share = 1.0;
  Spread spread{};
  bool settled = false;  // as it does where readings come at one pace: then every step is the same
  double log_deviation = 0.0;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (i == 0 || restarts[i]) {
      segments_.push_back({{}, 1});
      spread = {reading + alike, 0.0, drift_speed_variance(noise), -alike, 0.0, alike};
      settled = false;
      continue;
    }
    constexpr double as_long_s = 1e-9;
    const double unsteady_now = unsteady.empty() ? 1.0 : unsteady[i];
    if (std::abs(times_s[i] - times_s[i - 1] - duration_s) > as_long_s || unsteady_now != unsteady_share) {
      unsteady_share = unsteady_now;
      duration_s = times_s[i] - times_s[i - 1];
      drift = DriftStep(noise, duration_s, unsteady_share);
      tracker.kept = noise.tracker_kept(duration_s);
      tracker.variance = alike * (1.0 - tracker.kept * tracker.kept);
      settled = false;
    }
    if (settled) {
      ++segments_.back().readings;
    } else {
      const Spread before = spread;
      segments_.push_back({advance(spread, drift, tracker, reading), 1});
      settled = spread.as_good_as(before);
      log_deviation = -std::log(segments_.back().step.scale);
    }
    log_determinant_ += log_deviation;
    ++count_;
  }
}

void Whitener::apply(std::span<const double> errors, double* innovations) const {
  if (tracked_) {
    lasting_ ? apply_to<true, true>(errors, innovations) : apply_to<false, true>(errors, innovations);
  } else {
    lasting_ ? apply_to<true, false>(errors, innovations) : apply_to<false, false>(errors, innovations);
  }
}

// Most noise needs neither a speed nor a tracker, and each reading waits for the one before.
template <bool lasting, bool tracked>
void Whitener::apply_to(std::span<const double> errors, double* innovations) const {
  double begin = 0.0;  // where the series began
  double travel = 0.0;
  double speed = 0.0;
  double tracker = 0.0;
  std::size_t next = 0;
  for (const auto& [step, readings] : segments_) {
    if (step.scale == 0.0) {
      begin = errors[next];
      travel = speed = tracker = 0.0;
    }
    for (const std::size_t end = next + readings; next < end; ++next) {
      const double error = errors[next] - begin;
      const auto sum = [&](const Known& of) {
        double known = of.from_error * error;
        if constexpr (lasting) known += of.from_speed * speed;
        known += of.from_travel * travel;
        if constexpr (tracked) known += of.from_tracker * tracker;
        return known;
      };
      innovations[next] = (error - sum(step.expected)) * step.scale;
      const double travel_now = sum(step.travel);
      const double speed_now = lasting ? sum(step.speed) : 0.0;
      if constexpr (tracked) tracker = sum(step.tracker);
      travel = travel_now;
      speed = speed_now;
    }
  }
}

}  // namespace wheelwright::gap

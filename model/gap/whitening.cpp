#include "model/gap/whitening.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
// White noise drives a speed that decays at rate b, and that a travel that decays at rate a; the integrals
// are those of the squares and products of their impulse responses.
WanderStep::WanderStep(const TravelNoise& noise, double duration_s) {
  const double walk2 = noise.walk_per_sqrt_s * noise.walk_per_sqrt_s;
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

double wander_speed_variance(const TravelNoise& noise) {
  return noise.lasts_s > 0.0 ? noise.walk_per_sqrt_s * noise.walk_per_sqrt_s / (2.0 * noise.lasts_s) : 0.0;
}

bool Whitener::Spread::as_good_as(const Spread& other) const {
  const auto close = [](double a, double b) {
    constexpr double relative = 1e-12;
    return std::abs(a - b) <= relative * std::abs(b);
  };
  return close(travel, other.travel) && close(both, other.both) && close(speed, other.speed);
}

Whitener::Step Whitener::advance(Spread& spread, const WanderStep& wander, double reading) {
  const auto [travel, both, speed] = spread;
  const double ahead = wander.kept * both + wander.carry_s * speed;
  const double expected = wander.kept * (wander.kept * travel + wander.carry_s * both) +
                          wander.carry_s * ahead + wander.travel_variance;
  const double expected_both = wander.decay * ahead + wander.covariance;
  const double expected_speed = wander.decay * wander.decay * speed + wander.speed_variance;
  const double innovation = expected + reading;
  const double gain = expected / innovation;
  const double speed_gain = expected_both / innovation;
  spread = {(1.0 - gain) * expected, (1.0 - gain) * expected_both,
            expected_speed - speed_gain * expected_both};
  return {{wander.kept, wander.carry_s, 0.0},
          {(1.0 - gain) * wander.kept, (1.0 - gain) * wander.carry_s, gain},
          {-speed_gain * wander.kept, wander.decay - speed_gain * wander.carry_s, speed_gain},
          1.0 / std::sqrt(innovation)};
}

Whitener::Whitener(std::span<const double> times_s, std::span<const char> restarts,
                   const TravelNoise& noise) {
  const double reading = noise.reading * noise.reading;
  WanderStep wander(noise, 0.0);
  double duration_s = 0.0;
  Spread spread{};
  bool settled = false;  // as it does where readings come at one pace: then every step is the same
  double log_deviation = 0.0;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (i == 0 || restarts[i]) {
      stretches_.push_back({{}, 1});
      spread = {reading, 0.0, wander_speed_variance(noise)};
      settled = false;
      continue;
    }
    constexpr double as_long_s = 1e-9;
    if (std::abs(times_s[i] - times_s[i - 1] - duration_s) > as_long_s) {
      duration_s = times_s[i] - times_s[i - 1];
      wander = WanderStep(noise, duration_s);
      settled = false;
    }
    if (settled) {
      ++stretches_.back().readings;
    } else {
      const Spread before = spread;
      stretches_.push_back({advance(spread, wander, reading), 1});
      settled = spread.as_good_as(before);
      log_deviation = -std::log(stretches_.back().step.scale);
    }
    log_determinant_ += log_deviation;
    ++count_;
  }
}

void Whitener::apply(std::span<const double> errors, double* innovations) const {
  double begin = 0.0;  // where the series began
  double travel = 0.0;
  double speed = 0.0;
  std::size_t next = 0;
  for (const auto& [step, readings] : stretches_) {
    if (step.scale == 0.0) begin = errors[next];
    for (const std::size_t end = next + readings; next < end; ++next) {
      const double error = errors[next] - begin;
      const auto sum = [&](const Known& of) {
        return of.from_travel * travel + (of.from_speed * speed + of.from_error * error);
      };
      innovations[next] = (error - sum(step.expected)) * step.scale;
      const double travel_now = sum(step.travel);
      speed = sum(step.speed);
      travel = travel_now;
    }
  }
}

}  // namespace wheelwright::gap

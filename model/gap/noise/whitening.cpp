#include "model/gap/noise/whitening.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {
// White noise drives a speed that decays at rate b, and that a travel that decays at rate a; the integrals
// are those of the squares and products of their impulse responses.
DriftStep::DriftStep(const TravelNoise& noise, double duration_s, double unsteady) {
  const double intensity = unsteady + (1.0 - unsteady) * noise.steady_share * noise.steady_share;
  const double walk2 = noise.walk_per_sqrt_s * noise.walk_per_sqrt_s * intensity;
  const double a = 1.0 / noise.return_time_s;
  const auto integral = [duration_s](double rate) {
    return rate > 0.0 ? -std::expm1(-rate * duration_s) / rate : duration_s;
  };
  kept = std::exp(-a * duration_s);
  if (noise.drift_correlation_time_s <= 0.0) {
    carry_s = decay = 0.0;
    travel_variance = walk2 * integral(2.0 * a);
    return;
  }
  constexpr double apart = 1e-4;  // two equal rates have integrals of their own, which these come near to
  double b = 1.0 / noise.drift_correlation_time_s;
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
  return noise.drift_correlation_time_s > 0.0
             ? noise.walk_per_sqrt_s * noise.walk_per_sqrt_s / (2.0 * noise.drift_correlation_time_s)
             : 0.0;
}

double TravelNoise::tracker_kept(double duration_s) const {
  return tracker_correlation_time_s > 0.0 ? std::exp(-duration_s / tracker_correlation_time_s) : 0.0;
}

// The steps of the filter, one reading after the other.
class Whitener::Steps {
 public:
  Steps(std::span<const double> times_s, std::span<const char> restarts, const TravelNoise& noise,
        std::span<const double> unsteady)
      : times_s_(times_s), restarts_(restarts), unsteady_(unsteady), noise_(noise), drift_(noise, 0.0) {}

  std::size_t readings() const { return times_s_.size(); }
  // To reading `i`, the next one; whether it needs another step than the one before.
  bool advance_to(std::size_t i);
  const Step& step() const { return step_; }
  bool begins() const { return step_.scale == 0.0; }
  double log_deviation() const { return log_deviation_; }

 private:
  // Covariance of travel, its speed and the tracker's error as they are known after a reading.
  struct Spread {
    double travel;
    double travel_speed;
    double speed;
    double travel_tracker;
    double speed_tracker;
    double tracker;
    bool as_good_as(const Spread& other) const;
  };
  // How the tracker's error goes on.
  struct TrackerStep {
    double kept;
    double variance;
  };

  Step next_step();

  std::span<const double> times_s_;
  std::span<const char> restarts_;
  std::span<const double> unsteady_;
  const TravelNoise& noise_;
  DriftStep drift_;
  TrackerStep tracker_{1.0, 0.0};
  double duration_s_ = 0.0;
  double unsteady_share_ = 1.0;
  Spread spread_{};
  bool settled_ = false;  // as it does where readings come at one pace: then every step is the same
  Step step_{};
  double log_deviation_ = 0.0;
};

bool Whitener::Steps::Spread::as_good_as(const Spread& other) const {
  const auto close = [](double a, double b) {
    constexpr double relative = 1e-12;
    return std::abs(a - b) <= relative * std::abs(b);
  };
  return close(travel, other.travel) && close(travel_speed, other.travel_speed) &&
         close(speed, other.speed) && close(travel_tracker, other.travel_tracker) &&
         close(speed_tracker, other.speed_tracker) && close(tracker, other.tracker);
}

Whitener::Step Whitener::Steps::next_step() {
  const double ahead = drift_.kept * spread_.travel_speed + drift_.carry_s * spread_.speed;
  Spread expected{};
  expected.travel = drift_.kept * (drift_.kept * spread_.travel + drift_.carry_s * spread_.travel_speed) +
                    drift_.carry_s * ahead + drift_.travel_variance;
  expected.travel_speed = drift_.decay * ahead + drift_.covariance;
  expected.speed = drift_.decay * drift_.decay * spread_.speed + drift_.speed_variance;
  expected.travel_tracker =
      tracker_.kept * (drift_.kept * spread_.travel_tracker + drift_.carry_s * spread_.speed_tracker);
  expected.speed_tracker = tracker_.kept * drift_.decay * spread_.speed_tracker;
  expected.tracker = tracker_.kept * tracker_.kept * spread_.tracker + tracker_.variance;

  const double with_travel = expected.travel + expected.travel_tracker;
  const double with_speed = expected.travel_speed + expected.speed_tracker;
  const double with_tracker = expected.travel_tracker + expected.tracker;
  const double innovation = with_travel + with_tracker + noise_.reading * noise_.reading;
  const double gain = with_travel / innovation;
  const double speed_gain = with_speed / innovation;
  const double tracker_gain = with_tracker / innovation;
  spread_ = {expected.travel - gain * with_travel,
             expected.travel_speed - gain * with_speed,
             expected.speed - speed_gain * with_speed,
             expected.travel_tracker - gain * with_tracker,
             expected.speed_tracker - speed_gain * with_tracker,
             expected.tracker - tracker_gain * with_tracker};
  return {{drift_.kept, drift_.carry_s, tracker_.kept, 0.0},
          {(1.0 - gain) * drift_.kept, (1.0 - gain) * drift_.carry_s, -gain * tracker_.kept, gain},
          {-speed_gain * drift_.kept, drift_.decay - speed_gain * drift_.carry_s, -speed_gain * tracker_.kept,
           speed_gain},
          {-tracker_gain * drift_.kept, -tracker_gain * drift_.carry_s, (1.0 - tracker_gain) * tracker_.kept,
           tracker_gain},
          1.0 / std::sqrt(innovation)};
}

bool Whitener::Steps::advance_to(std::size_t i) {
  const double alike = noise_.tracker * noise_.tracker;
  if (i == 0 || restarts_[i]) {
    const double reading = noise_.reading * noise_.reading;
    spread_ = {reading + alike, 0.0, drift_speed_variance(noise_), -alike, 0.0, alike};
    settled_ = false;
    step_ = {};
    log_deviation_ = 0.0;
    return true;
  }
  constexpr double as_long_s = 1e-9;
  const double unsteady_now = unsteady_.empty() ? 1.0 : unsteady_[i];
  if (std::abs(times_s_[i] - times_s_[i - 1] - duration_s_) > as_long_s || unsteady_now != unsteady_share_) {
    unsteady_share_ = unsteady_now;
    duration_s_ = times_s_[i] - times_s_[i - 1];
    drift_ = DriftStep(noise_, duration_s_, unsteady_share_);
    tracker_.kept = noise_.tracker_kept(duration_s_);
    tracker_.variance = alike * (1.0 - tracker_.kept * tracker_.kept);
    settled_ = false;
  }
  if (settled_) return false;
  const Spread before = spread_;
  step_ = next_step();
  settled_ = spread_.as_good_as(before);
  log_deviation_ = -std::log(step_.scale);
  return true;
}

// Most noise needs neither a speed nor a tracker, and each reading waits for the one before.
template <bool lasting, bool tracked>
struct Whitener::State {
  double begin = 0.0;  // where the series began
  double travel = 0.0;
  double speed = 0.0;
  double tracker = 0.0;

  void begin_at(double error) {
    begin = error;
    travel = speed = tracker = 0.0;
  }
  double innovation(const Step& step, double measured) {
    const double error = measured - begin;
    const auto sum = [&](const Known& of) {
      double known = of.from_error * error;
      if constexpr (lasting) known += of.from_speed * speed;
      known += of.from_travel * travel;
      if constexpr (tracked) known += of.from_tracker * tracker;
      return known;
    };
    const double result = (error - sum(step.expected)) * step.scale;
    const double travel_now = sum(step.travel);
    const double speed_now = lasting ? sum(step.speed) : 0.0;
    if constexpr (tracked) tracker = sum(step.tracker);
    travel = travel_now;
    speed = speed_now;
    return result;
  }
};

Whitener::Whitener(std::span<const double> times_s, std::span<const char> restarts, const TravelNoise& noise,
                   std::span<const double> unsteady)
    : lasting_(noise.drift_correlation_time_s > 0.0), tracked_(noise.tracker > 0.0) {
  Steps steps(times_s, restarts, noise, unsteady);
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (steps.advance_to(i)) {
      segments_.push_back({steps.step(), 1});
    } else {
      ++segments_.back().readings;
    }
    log_determinant_ += steps.log_deviation();
  }
}

void Whitener::apply(std::span<const double> errors, double* innovations) const {
  if (tracked_) {
    lasting_ ? apply_to<true, true>(errors, innovations) : apply_to<false, true>(errors, innovations);
  } else {
    lasting_ ? apply_to<true, false>(errors, innovations) : apply_to<false, false>(errors, innovations);
  }
}

template <bool lasting, bool tracked>
void Whitener::apply_to(std::span<const double> errors, double* innovations) const {
  State<lasting, tracked> state;
  std::size_t next = 0;
  for (const auto& [step, readings] : segments_) {
    if (step.scale == 0.0) state.begin_at(errors[next]);
    for (const std::size_t end = next + readings; next < end; ++next) {
      innovations[next] = state.innovation(step, errors[next]);
    }
  }
}

InnovationSums Whitener::sums(std::span<const double> times_s, std::span<const char> restarts,
                              const TravelNoise& noise, std::span<const double> unsteady,
                              std::span<const double> errors) {
  const Steps steps(times_s, restarts, noise, unsteady);
  const bool lasting = noise.drift_correlation_time_s > 0.0;
  if (noise.tracker > 0.0) {
    return lasting ? sums_of<true, true>(steps, errors) : sums_of<false, true>(steps, errors);
  }
  return lasting ? sums_of<true, false>(steps, errors) : sums_of<false, false>(steps, errors);
}

template <bool lasting, bool tracked>
InnovationSums Whitener::sums_of(Steps steps, std::span<const double> errors) {
  InnovationSums sums;
  State<lasting, tracked> state;
  for (std::size_t i = 0; i < steps.readings(); ++i) {
    steps.advance_to(i);
    if (steps.begins()) {
      state.begin_at(errors[i]);
      continue;
    }
    const double innovation = state.innovation(steps.step(), errors[i]);
    sums.sum_squares += innovation * innovation;
    sums.log_determinant += steps.log_deviation();
    ++sums.count;
  }
  return sums;
}

}  // namespace wheelwright::gap

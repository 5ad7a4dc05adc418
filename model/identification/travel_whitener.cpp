#include "model/identification/travel_whitener.hpp"

#include <cmath>

namespace wheelwright {

WhiteningStep WhiteningGains::next(double periods, double reading_variance) {
  WhiteningStep step;
  if (!started_) {
    level_variance_ = reading_variance;
    drift_variance_ = 0.0;
    covariance_ = 0.0;
    started_ = true;
    step.starts = true;
    return step;
  }
  step.kept = std::exp(-periods / noise_.memory_periods);
  const double fading_periods = 0.5 * noise_.memory_periods;
  const double effective_periods =
      std::isinf(fading_periods) ? periods : -fading_periods * std::expm1(-periods / fading_periods);
  covariance_ *= step.kept;
  drift_variance_ = step.kept * step.kept * drift_variance_ + noise_.drift_ratio * effective_periods;

  const double level_share = level_variance_ + covariance_;
  const double drift_share = drift_variance_ + covariance_;
  const double variance = level_share + drift_share + reading_variance;
  step.level_gain = level_share / variance;
  step.drift_gain = drift_share / variance;
  step.scale = 1.0 / std::sqrt(variance);
  step.log_variance = std::log(variance);
  level_variance_ -= level_share * step.level_gain;
  drift_variance_ -= drift_share * step.drift_gain;
  covariance_ -= level_share * step.drift_gain;
  return step;
}

bool TravelWhitener::filter(const Eigen::RowVectorXd& row, const WhiteningStep& step,
                            Eigen::RowVectorXd& whitened) {
  if (step.starts) {
    level_ = row;
    drift_.setZero();
    return false;
  }
  drift_ *= step.kept;
  whitened = row - level_ - drift_;
  level_ += step.level_gain * whitened;
  drift_ += step.drift_gain * whitened;
  whitened *= step.scale;
  return true;
}

// First whether readings have ages of their own: refreshed at some rate, the age spreads over one period of
// it, in which a wheel at one tick per period makes one tick, like the rounding to ticks itself. Then how
// much the wheels drift, as if they never came back, then for how long, then how much once more: the
// likelihood hardly couples the two.
RelativeTravelNoise most_likely_travel_noise(
    double tick_m, double period_s,
    const std::function<double(const RelativeTravelNoise&)>& negative_log_likelihood) {
  RelativeTravelNoise best;
  double best_value = std::numeric_limits<double>::infinity();
  const auto consider = [&](const RelativeTravelNoise& candidate) {
    const double value = negative_log_likelihood(candidate);
    if (value >= best_value) return;
    best_value = value;
    best = candidate;
  };
  constexpr double never = std::numeric_limits<double>::infinity();
  for (const double age_speed : {never, tick_m / period_s}) {
    for (const double ratio : {0.0, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) consider({ratio, never, age_speed});
  }
  if (best.drift_ratio == 0.0) return best;
  for (const double memory_periods : {1000.0, 300.0, 100.0, 30.0, 10.0}) {
    consider({best.drift_ratio, memory_periods, best.age_speed_m_s});
  }
  for (const double factor : {1.0 / 3.0, 3.0}) {
    consider({factor * best.drift_ratio, best.memory_periods, best.age_speed_m_s});
  }
  return best;
}

}  // namespace wheelwright

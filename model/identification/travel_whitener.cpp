#include "model/identification/travel_whitener.hpp"

#include <cmath>

namespace wheelwright {

TravelWhitener::TravelWhitener(Eigen::Index columns, const TravelNoise& noise)
    : level_(columns), wander_(columns), noise_(noise) {}

bool TravelWhitener::filter(const Eigen::RowVectorXd& row, double periods, double reading_variance,
                            Eigen::RowVectorXd& whitened) {
  if (!started_) {
    level_ = row;
    wander_.setZero();
    level_variance_ = reading_variance;
    wander_variance_ = 0.0;
    covariance_ = 0.0;
    started_ = true;
    return false;
  }
  let_wander(periods);
  const double level_share = level_variance_ + covariance_;
  const double wander_share = wander_variance_ + covariance_;
  const double innovation_variance = level_share + wander_share + reading_variance;
  whitened = row - level_ - wander_;
  level_ += (level_share / innovation_variance) * whitened;
  wander_ += (wander_share / innovation_variance) * whitened;
  level_variance_ -= level_share * level_share / innovation_variance;
  wander_variance_ -= wander_share * wander_share / innovation_variance;
  covariance_ -= level_share * wander_share / innovation_variance;
  whitened /= std::sqrt(innovation_variance);
  log_variance_sum_ += std::log(innovation_variance);
  return true;
}

void TravelWhitener::let_wander(double periods) {
  const double kept = std::exp(-periods / noise_.memory_periods);
  const double fading_periods = 0.5 * noise_.memory_periods;
  const double effective_periods =
      std::isinf(fading_periods) ? periods : -fading_periods * std::expm1(-periods / fading_periods);
  wander_ *= kept;
  covariance_ *= kept;
  wander_variance_ = kept * kept * wander_variance_ + noise_.drift_ratio * effective_periods;
}

// First whether readings have ages of their own: refreshed at some rate, the age spreads over one period of
// it, in which a wheel at one tick per period makes one tick, like the rounding to ticks itself. Then how
// much the wheels wander, as if they never came back, then for how long, then how much once more: the
// likelihood hardly couples the two.
TravelNoise most_likely_travel_noise(
    double tick_m, double period_s,
    const std::function<double(const TravelNoise&)>& negative_log_likelihood) {
  TravelNoise best;
  double best_value = std::numeric_limits<double>::infinity();
  const auto consider = [&](const TravelNoise& candidate) {
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

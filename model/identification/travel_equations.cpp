#include "model/identification/travel_equations.hpp"

#include <algorithm>
#include <cmath>

#include "model/command_timeline.hpp"

namespace wheelwright {
namespace {

// A hole of more periods than this ends a stretch of known history.
constexpr double longest_hole_periods = 2.5;
// A wheel that was commanded within so many periods is taken to move.
constexpr double moving_window_periods = 6.0;

// The Kalman filter of a constant level plus a fading wander, read with unit noise. The level starts without
// knowledge, the wander at zero. Applied to each column alike it turns equations with that noise into
// independent ones.
class Whitener {
 public:
  Whitener(Eigen::Index columns, const TravelNoise& noise)
      : level_(columns), wander_(columns), noise_(noise) {}

  void restart() { started_ = false; }

  // Returns true and the whitened row where there is one; the first row only sets the level.
  // `reading_variance` is that of this row's white noise.
  bool filter(const Eigen::RowVectorXd& row, double periods, double reading_variance,
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

  double log_variance_sum() const { return log_variance_sum_; }

 private:
  void let_wander(double periods) {
    const double kept = std::exp(-periods / noise_.memory_periods);
    const double fading_periods = 0.5 * noise_.memory_periods;
    const double effective_periods =
        std::isinf(fading_periods) ? periods : -fading_periods * std::expm1(-periods / fading_periods);
    wander_ *= kept;
    covariance_ *= kept;
    wander_variance_ = kept * kept * wander_variance_ + noise_.drift_ratio * effective_periods;
  }

  Eigen::RowVectorXd level_;
  Eigen::RowVectorXd wander_;
  TravelNoise noise_;
  double level_variance_ = 1.0;
  double wander_variance_ = 0.0;
  double covariance_ = 0.0;
  double log_variance_sum_ = 0.0;
  bool started_ = false;
};

}  // namespace

double whitened_travel_equations(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                                 const TravelNoise& noise, const EquationSink& sink) {
  const auto columns = static_cast<Eigen::Index>(2 * taps);
  Whitener whitener(columns + 2, noise);
  Eigen::RowVectorXd row(columns + 2);
  Eigen::RowVectorXd whitened(columns + 2);
  Eigen::RowVectorXd regressors(columns);
  for (const auto& log : logs) {
    const CommandTimeline timeline(log);
    whitener.restart();
    double known_since_s = -1e300;  // the run starts from rest: its past is known to be zero
    double last_used_s = log.samples.front().t_s;
    for (std::size_t k = 0; k < log.samples.size(); ++k) {
      const DriveSample& sample = log.samples[k];
      if (k > 0 && sample.t_s - log.samples[k - 1].t_s > longest_hole_periods * log.period_s) {
        known_since_s = sample.t_s;
        whitener.restart();
      }
      const double oldest_s = sample.t_s - period_s * static_cast<double>(taps);
      if (!sample.ticks || oldest_s < known_since_s) continue;
      for (std::size_t i = 0; i < taps; ++i) {
        const WheelPair commanded = timeline.distance_m(sample.t_s - period_s * static_cast<double>(i));
        row[static_cast<Eigen::Index>(2 * i)] = commanded.left;
        row[static_cast<Eigen::Index>(2 * i + 1)] = commanded.right;
      }
      const WheelTicks& start = *log.samples.front().ticks;
      row[columns] = static_cast<double>(sample.ticks->left - start.left) * log.metres_per_tick->left;
      row[columns + 1] = static_cast<double>(sample.ticks->right - start.right) * log.metres_per_tick->right;
      const double periods = (sample.t_s - last_used_s) / period_s;
      last_used_s = sample.t_s;
      const WheelPair speed = timeline.mean_m_s(sample.t_s - moving_window_periods * period_s, sample.t_s);
      const double relative_speed =
          std::max(std::abs(speed.left), std::abs(speed.right)) / noise.age_speed_m_s;
      if (!whitener.filter(row, periods, 1.0 + relative_speed * relative_speed, whitened)) continue;
      regressors = whitened.head(columns);
      sink(regressors, whitened.tail<2>());
    }
  }
  return whitener.log_variance_sum();
}

}  // namespace wheelwright

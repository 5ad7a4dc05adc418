#include "model/identification/travel_equations.hpp"

#include <cmath>

#include "model/command_timeline.hpp"

namespace wheelwright {
namespace {

// A hole of more periods than this ends a stretch of known history.
constexpr double longest_hole_periods = 2.5;

// The Kalman filter of a level that walks and is read with unit noise, started without knowledge. Applied to
// each column alike it turns equations with that noise into independent ones.
class Whitener {
 public:
  Whitener(Eigen::Index columns, double drift_ratio) : level_(columns), drift_ratio_(drift_ratio) {}

  void restart() { started_ = false; }

  // Returns true and the whitened row where there is one; the first row only sets the level.
  bool filter(const Eigen::RowVectorXd& row, double periods, Eigen::RowVectorXd& whitened) {
    if (!started_) {
      level_ = row;
      variance_ = 1.0;
      started_ = true;
      return false;
    }
    const double predicted = variance_ + drift_ratio_ * periods;
    const double innovation_variance = predicted + 1.0;
    whitened = row - level_;
    level_ += (predicted / innovation_variance) * whitened;
    variance_ = predicted / innovation_variance;
    whitened /= std::sqrt(innovation_variance);
    log_variance_sum_ += std::log(innovation_variance);
    return true;
  }

  double log_variance_sum() const { return log_variance_sum_; }

 private:
  Eigen::RowVectorXd level_;
  double drift_ratio_;
  double variance_ = 1.0;
  double log_variance_sum_ = 0.0;
  bool started_ = false;
};

}  // namespace

double whitened_travel_equations(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                                 double drift_ratio, const EquationSink& sink) {
  const auto columns = static_cast<Eigen::Index>(2 * taps);
  Whitener whitener(columns + 2, drift_ratio);
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
      if (!whitener.filter(row, periods, whitened)) continue;
      regressors = whitened.head(columns);
      sink(regressors, whitened.tail<2>());
    }
  }
  return whitener.log_variance_sum();
}

}  // namespace wheelwright

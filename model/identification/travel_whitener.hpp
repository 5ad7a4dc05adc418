// Turns equations in wheel travel into independent ones.
#pragma once

#include <functional>
#include <limits>

#include <Eigen/Core>

namespace wheelwright {

// Noise of a travel reading, in units of its white part: white, plus a drift that grows like a random walk
// at first and fades later. Where the drift fades (wheel ripple, a speed controller that catches up), travel
// over long times is more exact than a random walk (slip) would leave it. A robot that refreshes its sensors
// on a clock of its own adds the age of each reading times the speed.
struct RelativeTravelNoise {
  double drift_ratio = 0.0;  // growth of the drift's variance per period, in variances of the white part
  double memory_periods = std::numeric_limits<double>::infinity();  // in which it fades by e; infinite: never
  // Commanded speed at which the unknown age of a reading doubles the white variance; infinite: ages are
  // alike.
  double age_speed_m_s = std::numeric_limits<double>::infinity();

  // Variance of one reading's white part while the wheels are commanded to move at this speed.
  double reading_variance(double speed_m_s) const {
    const double relative_speed = speed_m_s / age_speed_m_s;
    return 1.0 + relative_speed * relative_speed;
  }
};

// What one reading does to the filter below. It depends on when readings come, not on what they say.
struct WhiteningStep {
  bool starts = false;        // only sets the level
  double kept = 1.0;          // of the drift since the reading before
  double level_gain = 0.0;    // of the innovation
  double drift_gain = 0.0;    // the same
  double scale = 1.0;         // brings the innovation to the variance of one reading's white part
  double log_variance = 0.0;  // of the innovation, in units of that
};

// The Kalman filter of a constant level plus a fading drift, read with unit noise: its gains. The level
// starts without knowledge, the drift at zero.
class WhiteningGains {
 public:
  explicit WhiteningGains(const RelativeTravelNoise& noise) : noise_(noise) {}

  // The next reading belongs to another run, or follows a hole: its level is not known.
  void restart() { started_ = false; }

  // For the reading that follows the last one after so many periods.
  WhiteningStep next(double periods, double reading_variance);

 private:
  RelativeTravelNoise noise_;
  double level_variance_ = 1.0;
  double drift_variance_ = 0.0;
  double covariance_ = 0.0;
  bool started_ = false;
};

// That filter on the columns of equations: applied to each column alike it turns equations with that noise
// into independent ones.
class TravelWhitener {
 public:
  explicit TravelWhitener(Eigen::Index columns) : level_(columns), drift_(columns) {}

  // Returns true and the whitened row where there is one; the first row only sets the level.
  bool filter(const Eigen::RowVectorXd& row, const WhiteningStep& step, Eigen::RowVectorXd& whitened);

 private:
  Eigen::RowVectorXd level_;
  Eigen::RowVectorXd drift_;
};

// The noise with the smallest negative log-likelihood, by search. `tick_m` over `period_s` is the speed at
// which the age of a reading would matter as much as its rounding.
RelativeTravelNoise most_likely_travel_noise(
    double tick_m, double period_s,
    const std::function<double(const RelativeTravelNoise&)>& negative_log_likelihood);

}  // namespace wheelwright

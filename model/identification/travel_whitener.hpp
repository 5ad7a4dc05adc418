// Turns equations in wheel travel into independent ones.
#pragma once

#include <functional>
#include <limits>

#include <Eigen/Core>

namespace wheelwright {

// Noise of a travel reading, in units of its white part: white, plus a wander that grows like a random walk
// at first and fades later. Where the wander fades (wheel ripple, a speed controller that catches up), travel
// over long times is more exact than a random walk (slip) would leave it. A robot that refreshes its sensors
// on a clock of its own adds the age of each reading times the speed.
struct TravelNoise {
  double drift_ratio = 0.0;  // growth of the wander's variance per period, in variances of the white part
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

// The Kalman filter of a constant level plus a fading wander, read with unit noise. The level starts without
// knowledge, the wander at zero. Applied to each column alike it turns equations with that noise into
// independent ones.
class TravelWhitener {
 public:
  TravelWhitener(Eigen::Index columns, const TravelNoise& noise);

  // The next row belongs to another run, or follows a hole: its level is not known.
  void restart() { started_ = false; }

  // Takes the row that follows the last one after so many periods. Returns true and the whitened row where
  // there is one; the first row after a restart only sets the level.
  bool filter(const Eigen::RowVectorXd& row, double periods, double reading_variance,
              Eigen::RowVectorXd& whitened);

  // Of the logarithms of the variances that rows were divided by: what a likelihood needs.
  double log_variance_sum() const { return log_variance_sum_; }

 private:
  void let_wander(double periods);

  Eigen::RowVectorXd level_;
  Eigen::RowVectorXd wander_;
  TravelNoise noise_;
  double level_variance_ = 1.0;
  double wander_variance_ = 0.0;
  double covariance_ = 0.0;
  double log_variance_sum_ = 0.0;
  bool started_ = false;
};

// The noise with the smallest negative log-likelihood, by search. `tick_m` over `period_s` is the speed at
// which the age of a reading would matter as much as its rounding.
TravelNoise most_likely_travel_noise(
    double tick_m, double period_s, const std::function<double(const TravelNoise&)>& negative_log_likelihood);

}  // namespace wheelwright

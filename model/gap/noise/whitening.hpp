// What is noise in a series of travel, and what a series looks like once it is taken out.
//
// A reading of travel errs by white noise (quantisation, the reference's own noise), and by what a tracker's
// readings have in common for a part of a second, as it smooths them. Between readings the travel itself
// drifts (slip, what pushes a motor that no model predicts): by a random walk, or by a speed that is
// forgotten within a part of a second (Ornstein and Uhlenbeck, 1930); by less where commands are steady.
// Where a wheel's speed is held by a controller with an integral, what it lost comes back within seconds:
//
//   dx = (v - x / return_time) dt,   dv = -v / drift_correlation_time dt + q dW,   reading = x + tracker +
//   white
//
// The innovations of the Kalman filter for such a series are white with unit variance. Their sum of squares
// is a log likelihood, whatever the correlation of the errors themselves.
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace wheelwright::gap {

// In m, or in rad for a heading.
struct TravelNoise {
  double reading = 1e-3;                  // standard deviation of one reading, by itself
  double walk_per_sqrt_s = 1e-3;          // of the drifting, per square root of time, before it returns
  double drift_correlation_time_s = 0.0;  // until the drifting's speed is forgotten; zero: a random walk
  double return_time_s = std::numeric_limits<double>::infinity();  // until the travel comes back
  double tracker = 0.0;                     // standard deviation of what readings near each other err alike
  double tracker_correlation_time_s = 0.0;  // until that is forgotten
  double steady_share = 1.0;                // of the drifting that is left where commands are steady

  // Share of the tracker's common error that is left after some time.
  double tracker_kept(double duration_s) const;
};

// How travel that drifts goes on over some time: by itself and its speed, which decay, and by what comes to
// both.
struct DriftStep {
  // `unsteady` is the share of that time in which commands were not steady (steadiness.hpp).
  DriftStep(const TravelNoise& noise, double duration_s, double unsteady = 1.0);
  double kept;     // of the travel
  double carry_s;  // travel by the speed at its begin
  double decay;    // of the speed
  double travel_variance;
  double covariance = 0.0;
  double speed_variance = 0.0;
};
// Of the speed, at any time.
double drift_speed_variance(const TravelNoise& noise);

// What innovations are worth together.
struct InnovationSums {
  double sum_squares = 0.0;
  double log_determinant = 0.0;  // sum of log standard deviations
  std::size_t count = 0;
};

// The linear filter from errors to innovations for readings at given times. The first reading, and each one
// after a restart, tells only where the series begins: its innovation is zero.
class Whitener {
 public:
  // `unsteady`: of the time since the reading before, for each reading; empty: all of it.
  Whitener(std::span<const double> times_s, std::span<const char> restarts, const TravelNoise& noise,
           std::span<const double> unsteady = {});

  // Of one series of errors, whose filter is not needed again and not kept.
  static InnovationSums sums(std::span<const double> times_s, std::span<const char> restarts,
                             const TravelNoise& noise, std::span<const double> unsteady,
                             std::span<const double> errors);

  // Writes one innovation per error.
  void apply(std::span<const double> errors, double* innovations) const;
  // Sum of log standard deviations: the part of the likelihood that does not hang on the errors.
  double log_determinant() const { return log_determinant_; }

 private:
  // From what was known after the reading before: the error expected, and what is known after this one.
  struct Known {
    double from_travel;
    double from_speed;
    double from_tracker;
    double from_error;
  };
  struct Step {
    Known expected;
    Known travel;
    Known speed;
    Known tracker;
    double scale;  // one over the innovation's standard deviation; zero where it tells nothing
  };
  class Steps;
  template <bool lasting, bool tracked>
  struct State;
  template <bool lasting, bool tracked>
  void apply_to(std::span<const double> errors, double* innovations) const;
  template <bool lasting, bool tracked>
  static InnovationSums sums_of(Steps steps, std::span<const double> errors);

  // The same step for so many readings.
  struct Segment {
    Step step;
    std::size_t readings;
  };
  std::vector<Segment> segments_;
  bool lasting_ = false;
  bool tracked_ = false;
  double log_determinant_ = 0.0;
};

}  // namespace wheelwright::gap

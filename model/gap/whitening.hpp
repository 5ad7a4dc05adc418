// What is noise in a series of travel, and what a series looks like once it is taken out.
//
// A reading of travel errs by white noise (quantisation, the reference's own noise); between readings the
// travel itself wanders (a random walk: slip, what no model predicts). Of a series of errors with these two,
// the innovations of the Kalman filter for it are white with unit variance, so that their sum of squares is a
// log likelihood, whatever the correlation of the errors themselves (GAP.md, point 5).
#pragma once

#include <span>
#include <vector>

namespace wheelwright::gap {

struct TravelNoise {
  double reading = 1e-3;          // standard deviation of one reading
  double walk_per_sqrt_s = 1e-3;  // of the wandering, after one second
};

// The linear filter from errors to innovations for readings at given times. The first reading, and each one
// after a restart, tells only where the series begins: its innovation is zero.
class Whitener {
 public:
  Whitener(std::span<const double> times_s, std::span<const char> restarts, const TravelNoise& noise);

  // Writes one innovation per error.
  void apply(std::span<const double> errors, double* innovations) const;
  // Sum of log standard deviations: the part of the likelihood that does not hang on the errors.
  double log_determinant() const { return log_determinant_; }
  std::size_t innovations() const { return count_; }

 private:
  struct Step {
    double gain;
    double scale;  // one over the innovation's standard deviation; zero where it tells nothing
  };
  std::vector<Step> steps_;
  double log_determinant_ = 0.0;
  std::size_t count_ = 0;
};

// One series of errors, for noise_of.
struct NoiseSample {
  std::span<const double> times_s;
  std::span<const char> restarts;
  std::span<const double> errors;
};

// The noise under which the series are most likely; all series of one channel together. `smallest_reading` is
// the least that a reading can err (its quantisation).
TravelNoise noise_of(std::span<const NoiseSample> samples, double smallest_reading);

}  // namespace wheelwright::gap

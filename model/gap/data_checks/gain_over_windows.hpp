// How far one thing goes for another, over windows of a run: commands and counts, counts and places.
#pragma once

#include <algorithm>
#include <cmath>

namespace wheelwright::gap {

constexpr double gain_window_s = 0.5;
constexpr double gain_of_a_wrong_unit = 20.0;  // degrees give 57, centimetres 100
constexpr double gain_of_a_wrong_sign = -0.3;

// The gain, and what it is sure to within.
class GainOf {
 public:
  void add(double given, double seen) {
    ++windows_;
    given_squares_ += given * given;
    products_ += given * seen;
    seen_squares_ += seen * seen;
  }
  double gain() const { return products_ / given_squares_; }
  // Below by four standard errors, as the scatter of the windows has it.
  bool surely_below(double limit) const { return known() && gain() + 4.0 * standard_error() < limit; }
  bool surely_above(double limit) const { return known() && gain() - 4.0 * standard_error() > limit; }

 private:
  static constexpr double min_windows = 3.0;

  bool known() const { return windows_ >= min_windows && given_squares_ > 0.0; }
  double standard_error() const {
    const double left = std::max(0.0, seen_squares_ - products_ * products_ / given_squares_);
    return std::sqrt(left / (windows_ - 1.0) / given_squares_);
  }

  double windows_ = 0.0;
  double given_squares_ = 0.0;
  double products_ = 0.0;
  double seen_squares_ = 0.0;
};

}  // namespace wheelwright::gap

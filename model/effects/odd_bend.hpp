// A map that bends the same way for both signs: size (1 - a size - b size^2), up to where it would fall
// again, and level from there. Where it would be level below `min_top`, it bends less: what is level is a
// limit, and that is another effect.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelwright::effects {

class OddBend {
 public:
  OddBend(double a, double b, double min_top) : a_(a), b_(b) {
    const double discriminant = a * a + 3.0 * b;
    if (discriminant < 0.0) return;
    const double inverse_of_top = a + std::sqrt(discriminant);
    if (!(inverse_of_top > 0.0)) return;
    const double less = std::min(1.0, 1.0 / (inverse_of_top * min_top));
    a_ *= less;
    b_ *= less * less;
    top_ = 1.0 / (less * inverse_of_top);
  }

  double operator()(double value) const {
    const double size = std::min(std::abs(value), top_);
    return std::copysign(size * (1.0 - size * (a_ + b_ * size)), value);
  }

 private:
  double a_;
  double b_;
  double top_ = std::numeric_limits<double>::infinity();
};

}  // namespace wheelwright::effects

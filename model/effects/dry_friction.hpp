// Dry friction on a wheel whose drive is known only through a lag: what a motor without friction would do
// goes in, what friction leaves of it comes out.
//
// Of a first-order lag v' = (u - f - v) / lag with friction f, the linear part gives the part without
// friction, y' = (u - y) / lag. The rest obeys the same lag, driven by -f alone, and the drive itself is u =
// y + lag y'. So friction acts where it does in the robot, behind all dead time, and a standing wheel stands
// exactly.
//
// With a controller that integrates the error of speed, drive is added until nothing is taken any more. Where
// friction changes its direction, a way of 2 f / recovery_per_s is lost for good.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {

// Of a controller: 1 / FrictionLevels::recovery_per_s. `sizes` are those that a search begins with.
inline ParameterInfo recovery_parameter(std::vector<double> sizes) {
  ParameterInfo recovery{"recovery", "s", "in which the controller makes up for what friction takes",
                         0.01,       2.0, {}};
  recovery.sizes = std::move(sizes);
  recovery.scales_effect = false;
  return recovery;
}

struct FrictionLevels {
  double breakaway_m_s = 0.0;  // drive that a standing wheel needs
  double sliding_m_s = 0.0;    // speed that friction costs a moving one
  double lag_s = 0.1;
  double sticking_m_s = 0.002;  // a slower wheel stands again, unless its drive would break it away
  // A controller of the wheel's speed makes up for what friction takes: drive added' = this * speed taken.
  double recovery_per_s = 0.0;
};

class DryFriction {
 public:
  // The wheel's mean speed over the period; `frictionless_m_s` is what the linear part says. A long period is
  // gone through in steps, since friction sets in and turns around at a moment within it.
  double step(double frictionless_m_s, const FrictionLevels& levels, double period_s) {
    constexpr double usual_step_s = 0.02;
    const double steps = std::max(1.0, std::round(period_s / usual_step_s));
    const double change = (frictionless_m_s - frictionless_before_) / steps;
    const double first = frictionless_m_s - 0.5 * (steps - 1.0) * change;
    double sum = 0.0;
    for (double k = 0.0; k < steps; k += 1.0)
      sum += small_step(first + k * change, change, levels, period_s / steps);
    frictionless_before_ = frictionless_m_s;
    return sum / steps;
  }
  void reset() { *this = {}; }

 private:
  // `change` of the frictionless speed since the step before.
  double small_step(double frictionless_m_s, double change, const FrictionLevels& levels, double step_s) {
    const double drive = frictionless_m_s + levels.lag_s / step_s * change + added_;
    const double share = step_s / (step_s + levels.lag_s);
    if (rests_) {
      if (std::abs(drive) <= levels.breakaway_m_s) {
        added_ += step_s * levels.recovery_per_s * frictionless_m_s;
        return 0.0;
      }
      rests_ = false;
      direction_ = std::copysign(1.0, drive);
      taken_ = frictionless_m_s - change;  // all of it, while the wheel stood
    }
    taken_ += share * (levels.sliding_m_s * direction_ - added_ - taken_);
    added_ += step_s * levels.recovery_per_s * taken_;
    const double speed = frictionless_m_s - taken_;
    const bool stopped = speed * direction_ <= 0.0 || std::abs(speed) < levels.sticking_m_s;
    if (stopped && std::abs(drive) <= levels.breakaway_m_s) {
      rests_ = true;
      return 0.0;
    }
    if (speed * direction_ < 0.0) direction_ = -direction_;
    return speed;
  }

  double frictionless_before_ = 0.0;  // in the period before
  double taken_ = 0.0;                // from the frictionless speed, by now
  double added_ = 0.0;                // drive, by a controller
  double direction_ = 1.0;
  bool rests_ = true;
};

// Of both wheels alike.
class DryFrictionPair {
 public:
  void step(WheelPair& speed_m_s, const FrictionLevels& levels, double period_s) {
    speed_m_s = {left_.step(speed_m_s.left, levels, period_s),
                 right_.step(speed_m_s.right, levels, period_s)};
  }
  void reset() { *this = {}; }

 private:
  DryFriction left_;
  DryFriction right_;
};

}  // namespace wheelwright::effects

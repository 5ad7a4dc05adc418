// Which command makes a wheel settle at which speed: the inverse of a model's curve from command to speed.
//
// A linear model has one gain; with effects the curve bends, has a dead zone, ends in saturation. The curve
// is taken once, by running the model straight at many commands until it settles.
#pragma once

#include <span>
#include <vector>

#include "model/effects/effect.hpp"
#include "model/geometry/pose.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

class SteadyStateMap {
 public:
  SteadyStateMap(const LinearModel& linear_part, std::span<const EffectSetting> effects);

  // The commands at which the wheels settle at these speeds. A speed that cannot be had gives the nearest one
  // that can: in a dead zone either rest or the slowest motion, beyond saturation the fastest.
  WheelPair command_for(const WheelPair& speed_m_s) const;

  // The turn rate up to which a robot that drives ahead turns by less than half of what is commanded, as with
  // tyres that scrub; 0 where it follows any.
  double turn_dead_band_rad_s() const { return turn_dead_band_rad_s_; }

 private:
  struct Point {
    double command;
    double speed;
  };
  static double command_on(const std::vector<Point>& curve, double speed);

  std::vector<Point> left_;  // rising in both
  std::vector<Point> right_;
  double turn_dead_band_rad_s_ = 0.0;
};

}  // namespace wheelwright

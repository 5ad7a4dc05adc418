// Which command makes a wheel settle at which speed: the inverse of a model's curve from command to speed.
//
// A linear model has one gain; with effects the curve bends, has a dead zone, ends in saturation. The curve
// is taken once, by running the model straight at many commands until it settles.
#pragma once

#include <span>
#include <vector>

#include "model/effects/effect.hpp"
#include "model/geometry/pose.hpp"
#include "model/simulation/drive_limits.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/model_simulation.hpp"

namespace wheelwright {

class SteadyStateMap {
 public:
  SteadyStateMap(const LinearModel& linear_part, std::span<const EffectSetting> effects);

  // The commands at which the wheels settle at these speeds. A speed that cannot be had gives the nearest one
  // that can: in a dead zone either rest or the slowest motion, beyond saturation the fastest. Of the
  // commands that act alike, as where they act in steps, it is the middle one, and of those beyond saturation
  // one close to their edge: the edges are what a model knows least, and what lies far beyond saturation.
  WheelPair command_for(const WheelPair& speed_m_s) const;

  const DriveLimits& limits() const { return limits_; }

 private:
  struct Point {
    double command;
    double speed;
  };
  double turn_dead_band_rad_s(const ModelSimulation& at_rest, const LinearModel& linear_part) const;
  int straightening_periods(ModelSimulation at_rest, const LinearModel& linear_part) const;
  static double command_on(const std::vector<Point>& curve, double speed);
  struct Level {
    std::vector<Point>::const_iterator first;
    std::vector<Point>::const_iterator last;
  };
  static Level level_at(const std::vector<Point>& curve, std::vector<Point>::const_iterator point);
  static double middle_of_level(const std::vector<Point>& curve, std::vector<Point>::const_iterator point);

  std::vector<Point> left_;  // rising in both
  std::vector<Point> right_;
  DriveLimits limits_;
};

}  // namespace wheelwright

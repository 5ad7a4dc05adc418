// Blocks on the motion of the body: what floor, castor and geometry make of the wheels.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/benchmark/fourth_plant/block.hpp"

namespace plants::fourth {

// From 0 at rest to 1 when plainly rolling.
inline double rolling(double speed_m_s) {
  constexpr double plainly_m_s = 0.008;
  return std::tanh(std::abs(speed_m_s) / plainly_m_s);
}

// A wider or narrower track than the drawing says.
struct TurnRatio {
  double ratio;
  Twist operator()(Twist twist, const Moment& /*moment*/) const {
    twist.turn_rad_s *= ratio;
    return twist;
  }
};

// A castor dragged sideways brakes the forward motion.
struct DragWhileTurning {
  double drag_m;
  Twist operator()(Twist twist, const Moment& /*moment*/) const {
    const double lost_m_s = drag_m * std::abs(twist.turn_rad_s) * rolling(twist.forward_m_s);
    twist.forward_m_s -= std::copysign(std::min(lost_m_s, std::abs(twist.forward_m_s)), twist.forward_m_s);
    return twist;
  }
};

// Wide tyres scrub: the harder the turn, the more of it is lost.
struct Scrub {
  double scrub_s;
  Twist operator()(Twist twist, const Moment& /*moment*/) const {
    twist.turn_rad_s /= 1.0 + scrub_s * std::abs(twist.turn_rad_s);
    return twist;
  }
};

// A skewed axle pulls to one side as long as the robot rolls.
struct Pull {
  double rate_rad_s;
  Twist operator()(Twist twist, const Moment& /*moment*/) const {
    twist.turn_rad_s += rate_rad_s * rolling(twist.forward_m_s);
    return twist;
  }
};

// Rolling tyres creep downhill.
struct Creep {
  double speed_m_s;
  double downhill_rad;
  Twist operator()(Twist twist, const Moment& moment) const {
    const double creep_m_s = speed_m_s * rolling(twist.forward_m_s);
    twist.forward_m_s += creep_m_s * std::cos(moment.pose.heading_rad - downhill_rad);
    return twist;
  }
};

struct Disc {
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 0.0;
  [[nodiscard]] bool holds(const Pose& pose) const {
    return std::hypot(pose.x_m - x_m, pose.y_m - y_m) < radius_m;
  }
};

// A round rug on which the tyres lose way.
struct Rug {
  Disc disc;
  double grip;
  Twist operator()(Twist twist, const Moment& moment) const {
    if (!disc.holds(moment.pose)) return twist;
    return {grip * twist.forward_m_s, grip * twist.left_m_s, grip * twist.turn_rad_s};
  }
};

// A trailing castor swings round after the direction of travel has flipped; the kick fades with the way.
struct CastorSwing {
  double angle_rad;
  double way_m;
  bool side_follows_travel;
  double direction = 0.0;
  double rolled_m = 1.0e3;
  Twist operator()(Twist twist, const Moment& moment) {
    constexpr double min_m_s = 0.01;
    const double travel = std::copysign(1.0, twist.forward_m_s);
    if (std::abs(twist.forward_m_s) > min_m_s && travel != direction) {
      if (direction != 0.0) rolled_m = 0.0;
      direction = travel;
    }
    const double speed_m_s = std::abs(twist.forward_m_s);
    rolled_m += speed_m_s * moment.step_s;
    const double side = side_follows_travel ? direction : 1.0;
    twist.turn_rad_s += side * angle_rad * speed_m_s / way_m * std::exp(-rolled_m / way_m);
    return twist;
  }
};

}  // namespace plants::fourth

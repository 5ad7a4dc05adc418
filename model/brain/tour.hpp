// A drive between random points of a circle, as a route is driven: turns in place, straight legs, and curves
// where the corner is shallow. In a circle too small for the speed its legs are too short to reach it.
//
// A linear model of a robot with friction is a compromise between the speeds that it was fitted to. A model
// that has seen starts, turns and legs at the speed of the route is right there. The speed varies a little
// from one part of the tour to the next, so that speed steps of a robot round differently.
#pragma once

#include <cstddef>
#include <vector>

#include "model/brain/portable_random.hpp"
#include "model/geometry/pose.hpp"
#include "model/route/route_follower.hpp"

namespace wheelwright {

struct TourPlan {
  Checkpoint middle;  // of the circle
  double radius_m = 0.5;
  double speed_m_s = 0.2;
  double duration_s = 40.0;  // legs for at least so long are drawn
};

class Tour {
 public:
  Tour(TourPlan plan, const FollowerLimits& limits, PortableRandom& random);

  // Back to the first leg, from where the robot stands.
  void restart();

  // Wheel speeds wanted for the coming period, in m/s on the floor. After the last leg comes the first. Does
  // not allocate. `rest` as in RandomDrive::next.
  WheelPair steer(const Pose& rest);

 private:
  std::vector<RouteFollower> parts_;
  std::size_t part_ = 0;
  bool begins_part_ = true;
};

}  // namespace wheelwright

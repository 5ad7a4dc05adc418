// Steers along a route by a pose that somebody else keeps: the model's, or odometry.
//
// The robot answers with some tenths of a second of lag. So the follower looks at the pose at which the robot
// would come to rest if it were stopped now: a command moves that pose at once, which takes the lag out of
// the loop, and a stop at a checkpoint is the moment when the rest pose is there. Between sharp corners it
// aims at a point ahead on the leg; at sharp corners and at the end it stops and turns in place. A robot that
// turns on for a while when it is told to go straight (DriveLimits) does so at slight corners, too.
#pragma once

#include <cstddef>

#include "model/geometry/pose.hpp"
#include "model/geometry/sensor_period.hpp"
#include "model/route/route.hpp"
#include "model/simulation/drive_limits.hpp"

namespace wheelwright {

struct FollowerLimits {
  double period_s = default_period_s;
  double wheel_base_m = 0.235;
  double largest_wheel_speed_m_s = 0.3;
  double slowest_wheel_speed_m_s = 0.04;  // slower commands may fall into a robot's dead zone
  double acceleration_m_s2 = 0.4;
  double braking_m_s2 = 0.25;
  // Of one wheel's command while the robot turns on its way: a jump there draws the current of a stall.
  double largest_wheel_acceleration_m_s2 = 2.5;
};

class RouteFollower {
 public:
  RouteFollower(Route route, const FollowerLimits& limits);

  // Back to the start of the route, whose first leg begins at `start`.
  void restart(const Checkpoint& start = {});

  // Wheel speeds wanted for the coming period, in m/s at the floor. `rest` is relative to the start of the
  // route. Where the robot hardly follows small turn rates, it is steered straight until the heading is off
  // enough for a correction well beyond them; no wheel is asked for a speed that it does not reach.
  WheelPair steer(const Pose& rest, const DriveLimits& robot = {});

  // All checkpoints were visited and the robot is told to stand.
  bool finished() const { return state_ == State::finished; }
  // Number of checkpoints visited so far.
  std::size_t visited() const { return visited_; }
  const Route& route() const { return route_; }

 private:
  enum class State { turning, driving, finished };

  bool stops_at(std::size_t checkpoint, const DriveLimits& robot) const;
  WheelPair next_command(const Pose& rest, const DriveLimits& robot);
  WheelPair turn(const Pose& rest, const DriveLimits& robot);
  WheelPair drive(const Pose& rest, const DriveLimits& robot);
  double turn_rate_for(double error_rad, const DriveLimits& robot);
  void arrive(const Pose& rest, const DriveLimits& robot);
  double fastest_m_s(const DriveLimits& robot) const;
  WheelPair limited(double v_m_s, double w_rad_s, double largest_m_s) const;
  WheelPair eased(const WheelPair& wanted_m_s) const;

  Route route_;
  FollowerLimits limits_;
  State state_ = State::turning;
  std::size_t visited_ = 0;
  Checkpoint leg_start_;   // differs from the last checkpoint after a second try
  int further_tries_ = 3;  // to come within tolerance of the end
  double speed_now_ = 0.0;
  WheelPair command_m_s_;    // the last one
  bool correcting_ = false;  // the heading, beyond a dead band
};

}  // namespace wheelwright

// Where a robot is on the floor, and how it moves there.
//
// Frame: x forward, y left, theta counter-clockwise from x (ROS REP-103); metres and radians.
#pragma once

namespace wheelwright {

struct Pose {
  double x_m = 0.0;
  double y_m = 0.0;
  double theta_rad = 0.0;  // not wrapped: full turns are counted
};

// Motion of the middle of the axle.
struct Twist {
  double v_m_s = 0.0;    // forward
  double w_rad_s = 0.0;  // counter-clockwise
};

// Something that each of the two wheels has: a command, a speed, a distance.
struct WheelPair {
  double left = 0.0;
  double right = 0.0;
};

// The angle that differs from `angle_rad` by full turns and lies in (-pi, pi].
double wrap_angle(double angle_rad);

// Where an angle points. Small ones, of which a run seen from its own beginning has many, are quick.
struct Direction {
  double cosine;
  double sine;
};
Direction direction_of(double angle_rad);

// The pose after moving for `duration_s` with a constant twist, that is, along an arc (eq. 11 of the source
// paper).
Pose move_along_arc(const Pose& pose, const Twist& twist, double duration_s);

// `pose` as seen from `origin`: the pose of the same point in the frame whose origin and x axis are `origin`.
Pose between(const Pose& origin, const Pose& pose);

// The inverse: the pose that is at `offset` as seen from `origin`.
Pose compose(const Pose& origin, const Pose& offset);

double distance_between_m(const Pose& a, const Pose& b);

// Body motion from wheel speeds in m/s, and back.
inline Twist twist_of_wheels(const WheelPair& speed_m_s, double wheel_base_m) {
  return {0.5 * (speed_m_s.left + speed_m_s.right), (speed_m_s.right - speed_m_s.left) / wheel_base_m};
}
inline WheelPair wheels_of_twist(const Twist& twist, double wheel_base_m) {
  const double half_difference = 0.5 * twist.w_rad_s * wheel_base_m;
  return {twist.v_m_s - half_difference, twist.v_m_s + half_difference};
}

}  // namespace wheelwright

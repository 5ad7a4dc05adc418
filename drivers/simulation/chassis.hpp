// The robot's body as a rigid disc on two wheels and a caster, with what floor and walls do to it.
#pragma once

#include "drivers/simulation/caster.hpp"
#include "drivers/simulation/drive_unit.hpp"
#include "drivers/simulation/room.hpp"
#include "model/geometry/pose.hpp"

namespace wheelwright::simulation {

// Whether each wheel stands on the floor.
struct WheelContact {
  bool left = true;
  bool right = true;
};

class Chassis {
 public:
  Chassis(const ChassisConfig& config, const Pose& start);

  // Lets the wheels push the body and the body push the wheels for `duration_s`: traction with slip, slope,
  // drag, walls.
  void move(DriveUnit& left, DriveUnit& right, const Room& room, const WheelContact& contact,
            double duration_s);

  const Pose& pose() const { return pose_; }
  // Where the body will be if it goes on like this.
  Pose pose_after(double duration_s) const;
  double forward_speed_m_s() const { return forward_m_s_; }
  double turn_rate_rad_s() const { return turn_rad_s_; }
  double left_speed_m_s() const { return forward_m_s_ - turn_rad_s_ * 0.5 * config_.wheel_base_m; }
  double right_speed_m_s() const { return forward_m_s_ + turn_rad_s_ * 0.5 * config_.wheel_base_m; }
  double kinetic_energy_j() const;

  // A point given in the body frame, in the room's frame.
  Point in_room(double x_m, double y_m) const;
  Point heading() const { return {cos_heading_, sin_heading_}; }

  // What the bumper touches, in the body frame: 0 is straight ahead.
  bool touches() const { return touching_; }
  double touch_bearing_rad() const { return touch_bearing_rad_; }

 private:
  struct WheelLoad {
    double limit_n = 0.0;  // largest traction force; negative: no limit
    double creep_m_s_per_n = 0.0;
  };
  WheelLoad load(const DriveUnit& wheel, const Surface& surface, bool on_floor) const;
  void apply_body_forces(const Surface& left, const Surface& right, double duration_s);
  void apply_traction(DriveUnit& left, DriveUnit& right, const WheelLoad& left_load,
                      const WheelLoad& right_load, double duration_s);
  void stop_at_walls(const Room& room, double duration_s);

  ChassisConfig config_;
  Caster caster_;
  Pose pose_;
  double cos_heading_;
  double sin_heading_;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
  double free_way_m_ = 0.0;  // no wall can be reached before the body has moved this far
  double touch_bearing_rad_ = 0.0;
  bool touching_ = false;
};

}  // namespace wheelwright::simulation

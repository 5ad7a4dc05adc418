// A model as MJCF: the joints and actuators of its two wheels.
#pragma once

#include "tools/wheelwright/export/wheel_torque.hpp"

namespace wheelwright::tools {

// What has to be known of a wheel in a file.
struct MujocoSide {
  bool is_velocity = false;        // <velocity>, which has one gain for control and speed; else <general>
  double control_per_rad_s = 1.0;  // of the wheel, as its gear and gains are now
  double gear = 1.0;               // of a <general>, which keeps it; a <velocity> says the gain by it
  bool has_delay = false;          // already, so that a delay of 0 has to be said too
  bool takes_radius = true;        // so that what the motor speeds up grows with its square
};

struct MujocoTarget {
  MujocoSide left;
  MujocoSide right;
  double timestep_s = 0.002;       // as MuJoCo has it where a file does not say
  double control_per_rad_s = 1.0;  // of the wheel
  bool knows_delay = true;         // from MuJoCo 3.5 on; before, it becomes lag
};

// With an inertia; throws std::invalid_argument, in one line, where the linear part leaves no torque to be
// had.
ModelNumbers mujoco_numbers(const RobotModel& model, const WheelGeometry& wheel,
                            const MujocoTarget& target = {});

ModelText to_mujoco(const RobotModel& model, const WheelGeometry& wheel, const MujocoTarget& target = {});

}  // namespace wheelwright::tools

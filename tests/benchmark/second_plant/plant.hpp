#pragma once

#include <vector>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace plants::second {

// Rotor, gear and tyre of one side.
struct DriveTrain {
  DriveTrain(const RobotSpec& robot, const TyreSpec& tyre_spec, double start_angle_rad)
      : controller(robot.controller),
        motor(robot.motor),
        friction(robot.friction),
        grease(robot.grease),
        gear(robot.gear),
        tyre(tyre_spec),
        wheel_angle_rad(start_angle_rad) {}

  WheelController controller;
  Motor motor;
  Friction friction;
  Grease grease;
  Gear gear;
  TyreSpec tyre;
  double rotor_m_s = 0.0;
  double wheel_m_s = 0.0;
  double wheel_angle_rad;
};

// The robot's mechanics, integrated with a fixed step of 0.5 ms (semi-implicit Euler).
class Plant {
 public:
  static constexpr double kStep_s = 0.0005;

  Plant(const RobotSpec& robot, int run, const Pose& start, Random random);

  void receive(PerWheel<double> command_m_s) { firmware_.receive(now_s_, command_m_s); }
  void advance_to(double time_s);

  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] double wheel_angle_rad(std::size_t wheel) const { return trains_[wheel].wheel_angle_rad; }
  [[nodiscard]] double terminal_v() const { return battery_.terminal_v(); }

 private:
  void step();
  double step_train(std::size_t wheel, double target_m_s);
  [[nodiscard]] double floor_speed_m_s(std::size_t wheel) const;
  [[nodiscard]] double rug_share(std::size_t wheel) const;
  void step_body(const PerWheel<double>& traction_n, bool driving);

  RobotSpec robot_;
  Firmware firmware_;
  Battery battery_;
  Caster caster_;
  OddForce odd_force_;
  std::vector<DriveTrain> trains_;
  Pose pose_;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
  double acceleration_m_s2_ = 0.0;
  double now_s_ = 0.0;
  long steps_ = 0;
};

}  // namespace plants::second

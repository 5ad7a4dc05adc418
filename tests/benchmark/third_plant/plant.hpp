#pragma once

#include <vector>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/third_plant/robot_spec.hpp"

namespace plants::third {

// What turns one wheel.
struct DriveTrain {
  DriveTrain(const RobotSpec& robot, std::size_t wheel, double angle_rad, const Random& random)
      : controller(robot.controller),
        motor(robot.motor),
        friction(robot.friction, robot.rim_mass_kg),
        noise(robot.noise, random),
        gear(robot.gear[wheel], angle_rad),
        tyre(robot.tyre[wheel]) {}

  WheelController controller;
  Motor motor;
  Friction friction;
  WheelNoise noise;
  Gear gear;
  Tyre tyre;
  double motor_m_s = 0.0;
};

// The robot's mechanics, integrated with steps of 0.5 ms at the most (semi-implicit Euler).
class Plant {
 public:
  Plant(const RobotSpec& robot, int run, double run_s, const Pose& start, const Random& random);

  void receive(const PerWheel<double>& command_m_s) { firmware_.receive(now_s_, command_m_s); }
  void advance_to(double time_s);

  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] double wheel_travel_m(std::size_t wheel) const {
    return trains_[wheel].gear.wheel_travel_m();
  }
  [[nodiscard]] double terminal_v() const { return supply_.terminal_v(); }

 private:
  void step(double step_s);
  void step_motor(std::size_t wheel, double target_m_s, double supply_share, double step_s);
  double step_wheel(std::size_t wheel, double step_s);
  [[nodiscard]] double drag_n(std::size_t wheel, double step_s);
  [[nodiscard]] bool stands_on_rug(std::size_t wheel) const;
  void move(const BodyMotion& body, double step_s);

  RobotSpec robot_;
  Firmware firmware_;
  Supply supply_;
  Grease grease_;
  Derating derating_;
  OddForce odd_force_;
  Episodes slips_;
  Episodes loose_contacts_;
  Undercarriage undercarriage_;
  std::vector<DriveTrain> trains_;
  Pose pose_;
  double now_s_ = 0.0;
};

}  // namespace plants::third

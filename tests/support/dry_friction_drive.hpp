// A robot of two motors with dry friction and no speed controller, by the equation of motion in small steps:
//
//   lag dv/dt = gain u - v - friction sign(v),   at rest while |gain u| <= friction
//
// and a drive of it whose friction changes on the way. It shares nothing with the library of effects.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "model/log/sensor_frame.hpp"
#include "model/simulation/robot_model.hpp"
#include "tests/support/recorded_drive.hpp"

namespace wheelwright::test {

struct DryFrictionRobot {
  double gain = 1.02;
  double lag_s = 0.09;
  double metres_per_tick = 0.000444565;
};

class DryFrictionWheel {
 public:
  explicit DryFrictionWheel(const DryFrictionRobot& robot) : robot_(robot) {}

  void move(double command_m_s, double friction_m_s, double duration_s) {
    constexpr double step_s = 0.0005;
    for (double t_s = 0.0; t_s < duration_s; t_s += step_s) {
      const double drive = robot_.gain * command_m_s;
      const double opposing = std::copysign(friction_m_s, speed_m_s_ != 0.0 ? speed_m_s_ : drive);
      if (speed_m_s_ == 0.0 && std::abs(drive) <= friction_m_s) continue;
      const double next = speed_m_s_ + step_s / robot_.lag_s * (drive - speed_m_s_ - opposing);
      speed_m_s_ = next * speed_m_s_ < 0.0 ? 0.0 : next;
      way_m_ += step_s * speed_m_s_;
    }
  }
  double way_m() const { return way_m_; }
  std::int64_t ticks() const { return std::llround(std::floor(way_m_ / robot_.metres_per_tick)); }

 private:
  DryFrictionRobot robot_;
  double speed_m_s_ = 0.0;
  double way_m_ = 0.0;
};

// Random segments as routes have them. From `change_s` on friction is `after_m_s`.
inline std::vector<SensorFrame> dry_friction_drive(const DryFrictionRobot& robot, double before_m_s,
                                                   double after_m_s, double change_s, double duration_s,
                                                   std::uint64_t seed) {
  constexpr double period_s = 0.018;
  RandomSegments segments(seed);
  DryFrictionWheel left(robot);
  DryFrictionWheel right(robot);
  WheelPair command;
  std::vector<SensorFrame> frames;
  for (std::int64_t tick = 0; static_cast<double>(tick) * period_s < duration_s; ++tick) {
    const double friction_m_s = static_cast<double>(tick) * period_s < change_s ? before_m_s : after_m_s;
    left.move(command.left, friction_m_s, period_s);
    right.move(command.right, friction_m_s, period_s);
    command = segments.next();
    SensorFrame frame;
    frame.tick = tick;
    frame.valid = frame.armed = true;
    frame.ticks = frame.counted_ticks = {left.ticks(), right.ticks()};
    frame.command = {tick, command, Activity::route, 0};
    frame.battery_v = 14.5;
    frames.push_back(frame);
  }
  return frames;
}

// What gap makes of that robot: a lag of first order, and the effect.
inline RobotModel dry_friction_model(const DryFrictionRobot& robot, double friction_m_s) {
  constexpr double period_s = 0.018;
  const double kept = std::exp(-period_s / robot.lag_s);
  const double of_before = robot.lag_s / period_s * (1.0 - kept);  // share of the mean speed over a period
  const std::vector<double> none{0.0, 0.0};
  const std::vector<double> own{robot.gain * (1.0 - of_before),
                                robot.gain * (of_before * (1.0 - kept) - kept * (1.0 - of_before))};
  RobotModel model;
  model.encoder_scale = EncoderScale{{robot.metres_per_tick, robot.metres_per_tick}, 1661.0, 0.0005};
  model.linear_part = {ModelType::arma, period_s, 0.235, {own, none, {kept}}, {none, own, {kept}}};
  const WheelFit fit{{robot.gain, 0.0}, {0.002, 0.002}, 0.0003, 0.0006};
  model.left_fit = fit;
  model.right_fit = WheelFit{{0.0, robot.gain}, {0.002, 0.002}, 0.0003, 0.0006};
  AddedEffect friction;
  friction.setting = {"coulomb_friction", "", {friction_m_s, robot.lag_s}};
  friction.intervals = {{0.9 * friction_m_s, 1.1 * friction_m_s}, {0.08, 0.10}};
  model.effects.push_back(friction);
  return model;
}

}  // namespace wheelwright::test

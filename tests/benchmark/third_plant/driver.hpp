#pragma once

#include <deque>

#include "tests/benchmark/third_plant/planner.hpp"

namespace plants::third {

// Gives a command in every row, as planned from where the robot is seen to be.
class Driver {
 public:
  Driver(Style style, const DriveHabits& habits, const CommandLimits& limits, double run_s, Random random);

  PerWheel<double> command_m_s(double now_s, double period_s, const Pose& seen);

 private:
  [[nodiscard]] bool resting(double now_s) const;
  PerWheel<double> planned_m_s(double now_s, const Pose& seen);
  PerWheel<double> smoothed_m_s(const PerWheel<double>& wanted_m_s, double period_s);

  Style style_;
  bool turns_;
  double run_s_;
  double hand_s_;  // time constant of the hand on the joystick
  Planner planner_;
  std::deque<Segment> plan_;
  double segment_from_s_ = 0.0;
  PerWheel<double> hand_m_s_{};
};

}  // namespace plants::third

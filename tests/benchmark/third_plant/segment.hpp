#pragma once

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::third {

// Commands that go evenly from one pair to another.
struct Segment {
  double duration_s = 0.0;
  PerWheel<double> from_m_s{};
  PerWheel<double> to_m_s{};

  [[nodiscard]] PerWheel<double> at(double share) const {
    return {from_m_s[left_side] + share * (to_m_s[left_side] - from_m_s[left_side]),
            from_m_s[right_side] + share * (to_m_s[right_side] - from_m_s[right_side])};
  }
};

// What commands are kept to.
struct CommandLimits {
  double wheel_base_m = 0.25;
  double fastest_m_s = 0.35;
  double slowest_m_s = 0.0;  // of commands that are not zero
  double fastest_turn_rad_s = 2.0;
  bool reverses = true;
  bool turns = true;
};

inline Segment hold(double duration_s, const PerWheel<double>& command_m_s) {
  return {duration_s, command_m_s, command_m_s};
}

inline Segment rest(double duration_s) {
  return {duration_s, {}, {}};
}

// The motion asked for, slowed in proportion to what the limits allow.
Segment motion(double duration_s, double forward_m_s, double turn_rad_s, const CommandLimits& limits);

// Where an ideal robot would be after the segment.
Pose pose_after(const Segment& segment, const Pose& start, double wheel_base_m);

}  // namespace plants::third

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/third_plant/effects.hpp"

namespace plants::third {

// One robot with something (or nothing) hidden, how it is driven and what is measured.
struct Case {
  std::string subject;
  CaseKind kind = CaseKind::effects;
  std::vector<HiddenEffect> hidden;
  std::string size;
  Sensing sensing = Sensing::ticks;
  SensorSet sensors;
  Style style = Style::random_steps;
  DriveHabits habits;
  CommandLimits limits;
  RobotSpec robot;
  RobotSpec innocent;  // the robot without what is hidden
  std::uint64_t seed = 0;
};

// In an order that does not tell.
std::vector<Case> make_cases(std::uint64_t seed);

}  // namespace plants::third

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/second_plant/effects.hpp"
#include "tests/benchmark/second_plant/programme.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace plants::second {

// One robot with something (or nothing) hidden, how it is driven and what is measured.
struct Case {
  std::string name;
  CaseKind kind = CaseKind::effects;
  std::vector<std::string> hidden;
  std::string size;
  std::string note;
  RobotSpec robot;
  RobotSpec innocent;  // what the logs are compared with: the robot without what is hidden
  Sensing sensing = Sensing::ticks;
  SensorSet sensors;
  Style style = Style::rich;
  bool keep_heading = false;
  double duration_s = 75.0;
  std::uint64_t seed = 0;
};

std::vector<Case> make_cases(std::uint64_t seed);

}  // namespace plants::second

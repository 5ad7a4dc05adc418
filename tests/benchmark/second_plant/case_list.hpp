#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmark/second_plant/drive_log.hpp"
#include "tests/benchmark/second_plant/effects.hpp"
#include "tests/benchmark/second_plant/programme.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace second_plant {

// One robot with something (or nothing) hidden, how it is driven and what is measured.
struct Case {
  std::string name;
  std::string kind;  // single, several, clean, cannot_tell, outside
  std::vector<std::string> hidden;
  std::string size;
  std::string sensor_label;
  std::string note;
  RobotSpec robot;
  RobotSpec innocent;  // what the logs are compared with: the robot without what is hidden
  SensorSet sensors;
  Style style = Style::rich;
  bool keep_heading = false;
  double duration_s = 75.0;
  std::uint64_t seed = 0;
};

std::vector<Case> make_cases(std::uint64_t seed);

}  // namespace second_plant

#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/sensors.hpp"
#include "tests/benchmark/second_plant/random_robot.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace plants::second {

// One named imperfection: which numbers of a linear robot it changes.
struct Effect {
  std::string name;
  Drive drive = Drive::any;
  std::vector<Sensing> small_sensing;  // sensors that can show the small size
  std::vector<Sensing> large_sensing;
  bool needs_dense_poses = false;
  // `level` 0 = small, 1 = large.
  void (*apply)(RobotSpec& robot, double level, Random& random) = nullptr;
  std::string physics;
};

inline constexpr double large_level = 1.0;
inline constexpr double medium_level = 0.5;
inline constexpr double small_level = 0.0;

// Geometric interpolation between the small and the large size of an effect.
double sized(double small_value, double large_value, double level);

// The named effects, in three groups and all together.
std::vector<Effect> command_effects();
std::vector<Effect> drive_effects();
std::vector<Effect> floor_effects();
std::vector<Effect> all_effects();

// Structured imperfections that have no name in the table.
std::vector<Effect> outside_effects();

}  // namespace plants::second

#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/sensors.hpp"
#include "tests/benchmark/third_plant/planner.hpp"
#include "tests/benchmark/third_plant/random_robot.hpp"
#include "tests/benchmark/third_plant/robot_spec.hpp"

namespace plants::third {

// What an effect may change.
struct Setting {
  RobotSpec& robot;
  SensorSet& sensors;
  DriveHabits& habits;
  Random& random;
  bool large = true;
  bool alone = true;  // no other effect is hidden beside it

  [[nodiscard]] double sized(double small_low, double small_high, double large_low, double large_high) const {
    return large ? random.uniform(large_low, large_high) : random.uniform(small_low, small_high);
  }

  // A speed that is lost, as the force on each wheel that costs it without a closed loop.
  [[nodiscard]] double force_n(double speed_m_s) const { return speed_m_s * robot.drive_stiffness_n_s_m; }
};

// How an effect is shown when it is hidden alone.
struct Showing {
  Sensing sensing = Sensing::ticks;
  Style style = Style::random_steps;
  Loop loop = Loop::any;
  std::string confusable{};
};

// One imperfection as nature would do it: which numbers of a linear robot it changes.
struct Effect {
  std::string name;
  std::string (*apply)(Setting& setting) = nullptr;  // says what it did
  Showing small;
  Showing large;
  double min_reference_hz = 0.0;  // poses that come more seldom would not show it
  Response response = Response::any;
};

// The effects of the library, in three groups and all together.
std::vector<Effect> command_effects();
std::vector<Effect> drive_effects();
std::vector<Effect> floor_effects();
std::vector<Effect> all_effects();

// Structured imperfections that the library does not hold.
std::vector<Effect> outside_effects();

// For the sentences.
std::string millimetres(double length_m, int digits = 0);
std::string per_cent(double share, int digits = 0);

}  // namespace plants::third

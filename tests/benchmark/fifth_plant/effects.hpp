#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/fifth_plant/experiment.hpp"
#include "tests/benchmark/fifth_plant/random_robot.hpp"

namespace plants::fifth {

// What an effect is hidden in, and how large it is to be.
struct Setting {
  Experiment& experiment;
  Random& random;
  bool large;

  [[nodiscard]] Robot& robot() const { return experiment.robot; }
  [[nodiscard]] double drawn(double small_low, double small_high, double large_low, double large_high) const {
    return large ? random.uniform(large_low, large_high) : random.uniform(small_low, small_high);
  }
};

// How a case is driven and measured in which the effect can be told.
struct Showing {
  Sensing sensing = Sensing::ticks;
  Programme programme = Programme::teleoperation;
  Drive drive = Drive::any;
  double pose_every_s = -1.0;  // negative = any that is quick
  std::string confusable{};
  void (*prepare)(Robot& robot) = nullptr;  // what the robot has to have for the effect, without the effect
};

struct Effect {
  std::string name;
  Showing small;
  Showing large;
  std::string (*hide)(const Setting& setting) = nullptr;  // returns how
};

std::vector<Effect> command_effects();
std::vector<Effect> drive_effects();
std::vector<Effect> floor_effects();
std::vector<Effect> body_effects();
// The names of the contract.
std::vector<Effect> all_effects();

std::vector<Effect> outside_drive_effects();
std::vector<Effect> outside_place_effects();
std::vector<Effect> outside_signal_effects();
// Imperfections without a name.
std::vector<Effect> outside_effects();

}  // namespace plants::fifth

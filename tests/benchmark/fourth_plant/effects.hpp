#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/fourth_plant/experiment.hpp"
#include "tests/benchmark/fourth_plant/random_robot.hpp"

namespace plants::fourth {

// What an effect is hidden in, and how large it is to be.
struct Setting {
  Experiment& experiment;
  Random& random;
  bool large;

  [[nodiscard]] Robot& robot() const { return experiment.robot; }
  [[nodiscard]] Diagram& diagram() const { return experiment.robot.diagram; }
  [[nodiscard]] double top_m_s() const { return experiment.robot.top_m_s; }
};

struct Range {
  double low;
  double high;
};

inline double drawn(const Setting& setting, const Range& small, const Range& large) {
  const Range& range = setting.large ? large : small;
  return setting.random.uniform(range.low, range.high);
}

// How a case is driven and measured in which the effect can be told.
struct Showing {
  Sensing sensing = Sensing::ticks;
  Programme programme = Programme::random_steps;
  Loop loop = Loop::any;
  double pose_every_s = -1.0;  // negative = any that is quick
  std::string confusable{};
};

struct Effect {
  std::string name;
  Showing small;
  Showing large;
  std::string (*hide)(const Setting& setting) = nullptr;  // tells how
};

std::vector<Effect> command_effects();
std::vector<Effect> drive_effects();
std::vector<Effect> floor_effects();
std::vector<Effect> body_effects();

// The 26 names.
std::vector<Effect> all_effects();
// Imperfections without a name.
std::vector<Effect> outside_effects();

}  // namespace plants::fourth

#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/sixth_plant/channels.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/programmes.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

struct EffectEntry {
  Effect effect;
  std::string name;
  double smallest;
  double largest;
  std::vector<Programme> programmes;  // in which it shows
  std::vector<Channels> channels;     // by which it shows
  // The physics of it.
  std::string (*how)(double size, const Robot& robot, const Details& details);
  std::string confusable{};  // names, apart by spaces, that ordinary logs cannot tell from it
  // Share of the usual ratio to the noise at which it is seen: what is periodic or rare is seen long before
  // its mean square over the whole log is several times that of the noise.
  double rarity = 1.0;
};

std::vector<EffectEntry> command_effects();
std::vector<EffectEntry> drive_effects();
std::vector<EffectEntry> wheel_effects();
std::vector<EffectEntry> floor_effects();
std::vector<EffectEntry> measurement_effects();
// The names of the contract.
std::vector<EffectEntry> named_effects();

std::vector<EffectEntry> outside_command_effects();
std::vector<EffectEntry> outside_motion_effects();
// Imperfections without a name.
std::vector<EffectEntry> outside_effects();

bool is_named(Effect effect);
const EffectEntry& entry_of(Effect effect);

}  // namespace plants::sixth

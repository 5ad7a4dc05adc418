// What can be hidden in the robot of the gap benchmark: the names of the effects, in sizes that a person
// would call small, medium and large, and what a log must hold for anybody to tell.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::test {

enum class Severity { small, medium, large };

std::string_view name_of(Severity severity);
std::optional<Severity> severity_named(std::string_view name);

// What must be in the data for an effect to be there at all.
struct Needs {
  bool ticks = false;      // encoder counts
  bool reference = false;  // poses from outside: wheels and encoders know nothing of it
  bool reversals = false;
  bool turns = false;
  bool both = false;        // counts and poses side by side: of poses alone a linear part takes it up
  bool many_poses = false;  // more of them than the first and the last
  bool speeds = false;      // more than one speed
  bool turns_it = false;    // beside counts, a gyro shows it as poses do
  bool battery = false;     // else nobody can tell it from a drift with time
};

struct HiddenEffect {
  std::string_view name;
  std::array<double, 3> sizes;  // small, medium, large
  std::string_view unit;        // of the sizes
  std::string_view size_means;
  Needs needs;
  // Names that ordinary logs cannot tell from it, blank separated.
  std::string_view confusable;

  double size(Severity severity) const { return sizes.at(static_cast<std::size_t>(severity)); }
};

// The 26 names of the library, and the effects that no library holds: their names start with "outside_".
std::span<const HiddenEffect> hidden_effects();
const HiddenEffect* find_hidden_effect(std::string_view name);
bool is_outside_library(const HiddenEffect& effect);

// "a+b+c" as its effects; nothing where a name is unknown or stands twice. "clean" has none.
std::optional<std::vector<const HiddenEffect*>> effects_of_case(std::string_view case_name);

}  // namespace wheelwright::test

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/benchmark/sixth_plant/effects.hpp"

namespace plants::sixth {

enum class Size { none, small, medium, large };

// What a case asks of those who judge its logs.
enum class Expected { named, nothing_missing, unnamed, not_named };

std::string name_of(Size size);
std::string name_of(Expected expected);

// A case before anything is drawn for it.
struct PlannedCase {
  std::string name;
  std::vector<Effect> hidden;
  Size size = Size::none;
  Expected expected = Expected::named;
  std::optional<Programme> programme{};  // without one, both are drawn of those that show the effect
  std::optional<Channels> channels{};
  std::uint64_t seed = 0;
};

// Each name in two sizes, several at once, none, such as have no name, and such as the drives cannot show.
std::vector<PlannedCase> planned_cases(std::uint64_t seed);

}  // namespace plants::sixth

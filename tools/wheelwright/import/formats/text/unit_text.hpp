// Units that stand in brackets behind a name: "t [ms]", "speed (m/s)".
#pragma once

#include <string>
#include <string_view>

namespace wheelwright::import {

struct NameAndUnit {
  std::string name;
  std::string
      unit;  // empty where the brackets are absent, empty, or hold something else: "v (left)", "pose[0]"
};
NameAndUnit split_unit(std::string_view name);

// Whether a text is made of the symbols of units alone: "m", "rad/s", "m s^-2", "counts".
bool is_unit(std::string_view text);

}  // namespace wheelwright::import

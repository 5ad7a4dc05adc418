// Short drives on free floor that are known to show what ordinary drives hide.
#pragma once

#include <string>
#include <vector>

#include "model/geometry/pose.hpp"

namespace wheelwright::gap {

struct Manoeuvre {
  std::string name;                     // as a person says it: "slow triangle through zero"
  std::vector<WheelPair> commands_m_s;  // one per period; begins and ends with half a second of rest
};

struct ManoeuvreLimits {
  double largest_speed_m_s = 0.3;  // of a wheel
  // Of a wheel at once; larger changes are made in several steps, 0.15 s each. Harder ones make a Roomba
  // report an overcurrent, for which the daemon stops.
  double largest_change_m_s = 0.15;
  double radius_m = 1.0;  // of the free floor around the start
};

// The menu, each of 10 to 30 s but for one of a minute at constant speed. No command is faster and no change
// harder than the limits; the paths fit into the circle for a robot that does what it is told, which is for
// the caller to check with a model. Depends on nothing but its arguments.
std::vector<Manoeuvre> safe_manoeuvres(const ManoeuvreLimits& limits, double wheel_base_m, double period_s);

}  // namespace wheelwright::gap

// Counts that stand still or miss edges are lost, or true of a wheel that something held: references tell.
#pragma once

#include <span>

#include "model/gap/data_checks/commanded_stillness.hpp"
#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Counts that may be lost, and the travel that would be lost with them, with its sign.
struct Suspect {
  Freeze freeze;
  double lost_m = 0.0;
};

// Whether a reference saw the robot move as the counts say, to within so much travel of one wheel. False
// where it saw the robot not.
bool moved_as_counted(const GateState& gate, std::size_t first, std::size_t end, double within_m);

// All suspects that references saw. Each is watched from as long before it as it lasts to as long after it:
// a late reference shows a stop late.
SeenRolling seen_rolling(const GateState& gate, std::span<const Suspect> suspects);

// Whether references saw, of all of it together, that the wheels did not turn: they err by too much to tell
// of each short stop by itself.
bool were_held(const SeenRolling& here, const SeenRolling& elsewhere);

}  // namespace wheelwright::gap

// Counts that stand still or miss edges: were they lost, or did something hold the wheel? A reference that
// saw the robot move meanwhile says that they were lost.
#pragma once

#include <span>

#include "model/gap/data_checks/commanded_stillness.hpp"
#include "model/gap/data_checks/gate_state.hpp"

namespace wheelwright::gap {

// Counts that may be lost (freeze: the rows, commanded_stillness.hpp), and the travel of the wheel that would
// be lost with them, with its sign.
struct SuspectedLoss {
  Freeze freeze;
  double lost_m = 0.0;
};

// Whether a reference saw the robot move from row `first` to row `end` as the counts say, to within so much
// travel of one wheel. False where no reference saw the robot.
bool moved_as_counted(const GateState& gate, std::size_t first, std::size_t end, double within_m);

// What references saw of all suspects together (data_gate.hpp). Each is watched over three times its
// duration, with itself in the middle, because a late reference shows a stop late.
SeenRolling seen_rolling(const GateState& gate, std::span<const SuspectedLoss> suspects);

// Whether references saw, of all suspects together, that the wheels did not turn. Their errors are too large
// to decide each short stop by itself.
bool were_held(const SeenRolling& here, const SeenRolling& elsewhere);

}  // namespace wheelwright::gap

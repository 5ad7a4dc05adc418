// Wheels that stand for as long as little is asked of them: a dead zone, not an encoder that loses counts.
#pragma once

#include <cstddef>
#include <span>

#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

// So often something is no accident: once may be a wheel that something held.
constexpr std::size_t more_than_chance = 2;

// Rows in which the counts of one wheel stand still: those behind `first`, to `end`.
struct Freeze {
  std::size_t first = 0;
  std::size_t end = 0;
  bool left = false;
};

// Whether commands no larger than in `freezes` move neither wheel anywhere else in the log either. One freeze
// alone says nothing.
bool stand_by_command(const DriveLog& log, std::span<const Freeze> freezes);

}  // namespace wheelwright::gap

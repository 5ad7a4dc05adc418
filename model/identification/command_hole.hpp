// A range of commands at which the wheels stand still, though smaller and larger ones move them: no dead
// zone, which begins at zero, and no steps of the speed.
#pragma once

#include <cstddef>
#include <optional>

#include "model/identification/steady_state_speeds.hpp"

namespace wheelwright {

struct CommandHole {
  double from_m_s = 0.0;  // smallest and largest size of a held command that moves nothing
  double to_m_s = 0.0;
  double moves_below_m_s = 0.0;  // the nearest ones that move the wheel
  double moves_above_m_s = 0.0;
  std::size_t commands = 0;  // in the hole

  bool holds(double command_m_s) const;
};

// The size of a command counts, not its direction or its wheel; nothing where fewer than three commands stand
// in the hole, or fewer than two that surely move the wheel on either side of it.
std::optional<CommandHole> find_command_hole(const SteadyStateSpeeds& speeds);

// The settled speeds without those of the hole.
SteadyStateSpeeds without_hole(SteadyStateSpeeds speeds, const CommandHole& hole);

}  // namespace wheelwright

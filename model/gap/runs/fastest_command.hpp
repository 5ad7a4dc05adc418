// The largest command of some runs, of either wheel and either way, m/s; 0 without any.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "model/gap/runs/run.hpp"

namespace wheelwright::gap {

inline double fastest_command_m_s(std::span<const GapRun> runs) {
  double fastest_m_s = 0.0;
  for (const GapRun& run : runs) {
    for (const WheelPair& command : run.commands_m_s)
      fastest_m_s = std::max({fastest_m_s, std::abs(command.left), std::abs(command.right)});
  }
  return fastest_m_s;
}

}  // namespace wheelwright::gap

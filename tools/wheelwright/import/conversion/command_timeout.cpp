#include "tools/wheelwright/import/conversion/command_timeout.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheelwright::import {

void stop_after_timeout(DriveColumns& columns, double timeout_s) {
  constexpr double rounding_s = 1e-9;
  double last_s = nothing;  // of a command that is in force
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    const double t_s = columns.t_s[row];
    const bool is_said = std::ranges::any_of(columns.command, [row](const Column& command) {
      return !command.empty() && std::isfinite(command[row]);
    });
    if (is_said) {
      last_s = t_s;
    } else if (t_s - last_s > timeout_s + rounding_s) {
      for (Column& command : columns.command)
        if (!command.empty()) command[row] = 0.0;
      last_s = nothing;
    }
  }
}

}  // namespace wheelwright::import

// The direction of wheels whose encoders do not tell it.
#pragma once

#include <span>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"

namespace wheelwright::import {

// Gives running counts that never fall (or, for `are_speeds`, speeds that are never negative) the direction
// that `command` asks for at each row. Where it changes its sign the wheel still rolls on: it turns about
// where its speed is least.
void direct_by_command(Column& values, bool are_speeds, std::span<const double> command);

}  // namespace wheelwright::import

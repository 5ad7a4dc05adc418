// Commands and measured speeds of mapped columns, row by row, as a response is fitted to them.
#pragma once

#include <array>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Speed of both wheels and the command of each, of the mapped columns: in units of the channels per second.
// Rows that are nearer than 50 ms are put together: their mean speed and command.
std::array<ResponseRows, 2> response_rows(const DriveColumns& columns, const Mapping& mapping);

}  // namespace wheelwright::import

// What the motion says of commands that are not one speed for each wheel: which value of a bit is forward,
// and how throttle and steering are mixed.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// The value of the bits of direction at which the counts rise. Adds a line to `findings` where it is not 1,
// and to `doubts` where the motion does not tell.
void infer_forward_bit(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                       std::vector<std::string>& findings, std::vector<std::string>& doubts);

// The share and the sign of the steering beside the throttle.
void infer_steering(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings, std::vector<std::string>& doubts);

}  // namespace wheelwright::import

// The heading beside the places of a reference, by the names of columns.
#pragma once

#include <array>

#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// The parts of a quaternion as they turn about z; where y points up, about y. Those that are null are absent.
void take_quaternion(const Stream& stream, const std::array<const Channel*, 4>& xyzw, bool y_is_up,
                     ReferenceMapping& reference);

// Beside the places `x`: a quaternion, else a heading by its name unless `has_heading` is false, else the
// turn about the axis that points up, else an angle that says no more.
void take_heading(const Named& x, bool y_is_up, bool has_heading, const NamedChannels& named,
                  ReferenceMapping& reference);

}  // namespace wheelwright::import

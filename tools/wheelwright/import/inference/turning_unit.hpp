// Whether a turning motion of the body that the file gives no unit is in radians or in degrees.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Sets `wheels.angular_unit` to degrees, with a line in `findings`, where the robot then turns as commanded
// and in radians does not. The wheel base has to be known.
void infer_turning_unit(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                        std::vector<std::string>& findings);

}  // namespace wheelwright::import

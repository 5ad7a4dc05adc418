#pragma once

#include <vector>

#include "tests/benchmark/third_plant/case_list.hpp"

namespace plants::third {

std::vector<Run> drive(const Case& item);

// The commands of `driven` again, given to the robot without what is hidden.
std::vector<Run> drive_innocent(const Case& item, const std::vector<Run>& driven);

}  // namespace plants::third

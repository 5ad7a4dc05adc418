// What the counters of a log lack that a running count with a sign has, by the motion: whether they hold the
// travel since the row before, whether they hold a direction, and whether they go around too fast.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Sets what is not given; adds a line with the evidence to `findings`, and to `doubts` where the motion
// leaves it open.
void infer_counters(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings, std::vector<std::string>& doubts);

}  // namespace wheelwright::import

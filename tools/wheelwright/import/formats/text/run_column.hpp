// A column whose value tells runs apart: "trial", "session", "run_id".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Whether a name is that of a run, alone or with "id", "no" and their like.
bool names_a_run(std::string_view name);

// Whether each value of a column stands in one stretch of rows, and there are several. Rows without one
// belong to those before them.
bool are_stretches(const std::vector<double>& values);

// Sets where the runs of a stream begin, unless it knows; adds a line to `remarks`.
void find_runs(Stream& stream, std::vector<std::string>& remarks);

}  // namespace wheelwright::import

// The end points of all attempts, as a table and as a picture.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/evaluation/attempt.hpp"

namespace wheelwright::tools {

// CSV `model,attempt,x,y,theta` in m and rad: where each attempt truly ended, as seen from its start. Those
// that did not come to their end are left out.
std::string end_points_csv(const std::vector<AttemptOutcome>& outcomes);

// A gnuplot script that draws such a CSV, one panel per candidate, all to one scale. Names in it are relative
// to the folder that it is run in.
std::string end_points_script(const std::vector<AttemptOutcome>& outcomes, const std::string& csv_name,
                              const std::string& svg_name);

}  // namespace wheelwright::tools

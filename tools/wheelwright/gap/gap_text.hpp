// What the gap workflow found, for a person at a terminal.
#pragma once

#include <iosfwd>

#include "model/gap/gap_analysis.hpp"

namespace wheelwright::tools {

void print_gap(std::ostream& out, const gap::GapAnalysis& analysis);

}  // namespace wheelwright::tools

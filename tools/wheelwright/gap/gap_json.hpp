// gap.json: what the gap workflow found, for programs. The format is a contract (README.md, gap.json).
#pragma once

#include <string>

#include "model/gap/gap_analysis.hpp"

namespace wheelwright::tools {

std::string gap_to_json(const gap::GapAnalysis& analysis);

}  // namespace wheelwright::tools

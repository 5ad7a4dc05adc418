// `wheelwright fit --json`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tools/wheelwright/fit/fit_report.hpp"

namespace wheelwright::tools {

// Speeds in m/s, distances in m, times in s. Absent: `orders` where the order was given, `bend` and `steps`
// where the settled speeds do not show them.
nlohmann::ordered_json fit_json(const FitReport& report, const std::string& model_file);

}  // namespace wheelwright::tools

// An evaluation (`wheelwright evaluate -o DIR`), for a person: end points, and the table beside the paper's.
#pragma once

#include <filesystem>
#include <string>

namespace wheelwright::tools {

bool is_evaluation(const std::filesystem::path& folder);

// Throws config::LogError or UsageError where end_points.csv or evaluation.json cannot be read.
std::string evaluation_section(const std::filesystem::path& folder);

}  // namespace wheelwright::tools

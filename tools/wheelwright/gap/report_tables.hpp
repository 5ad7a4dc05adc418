// The tables of report.html, each as a section of the page; empty where there is nothing to say.
#pragma once

#include <optional>
#include <string>

#include "model/gap/analysis.hpp"
#include "model/gap/error_sources/residual_table.hpp"

namespace wheelwright::tools {

std::string findings_section(const gap::GapAnalysis& analysis);
std::string where_section(const gap::GapAnalysis& analysis);
std::string gap_section(const gap::GapAnalysis& analysis);
std::string residual_section(const std::optional<gap::ResidualTable>& table);
std::string search_section(const gap::GapAnalysis& analysis);
std::string limits_section(
    const gap::GapAnalysis& analysis);  // what could not be tested, what would have shown
std::string faults_section(const gap::GapAnalysis& analysis);

}  // namespace wheelwright::tools

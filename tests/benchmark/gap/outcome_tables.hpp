// The tables of the gap benchmark.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/benchmark/gap/case_outcome.hpp"

namespace wheelwright::test {

// Hit rate against size for each effect, by channels, of several effects at once; false names; the confusion
// matrix; gap closed; time; and the goals, each met or not.
std::string outcome_tables(const std::vector<CaseOutcome>& outcomes);

// The same figures and every case, for programs.
nlohmann::json outcome_json(const std::vector<CaseOutcome>& outcomes);

}  // namespace wheelwright::test

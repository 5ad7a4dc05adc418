// Table II as it comes out, beside Table II as it was published.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/wheelwright/evaluation/attempt.hpp"
#include "tools/wheelwright/evaluation/candidate.hpp"
#include "tools/wheelwright/evaluation/offset_statistics.hpp"

namespace wheelwright::tools {

// A published row is met where every attempt came to its end and the mean offset exceeds the published one by
// at most this share of it. The simulated robot is of the paper's kind, not the paper's.
inline constexpr double mean_tolerance = 0.3;

struct OffsetRow {
  Candidate candidate;
  std::size_t attempts = 0;
  std::size_t finished = 0;
  std::optional<OffsetStatistics> offset;  // over those that finished, if any did
  std::string first_failure;               // why the first of the others did not
  std::optional<bool> met;                 // absent where nothing was published
  // Of those that finished, so many ended within the 95 % ellipse of what steered them; absent where it
  // states none.
  std::optional<std::size_t> inside_ellipse95;
};

// One row per candidate that was not left out. `outcomes` holds at least one attempt.
std::vector<OffsetRow> offset_rows(const std::vector<AttemptOutcome>& outcomes, std::uint64_t seed);

bool all_met(const std::vector<OffsetRow>& rows);

// `of_one_calibration` holds the same rows with one calibration before all attempts, or nothing.
void print_offset_table(std::ostream& out, const std::vector<OffsetRow>& rows,
                        const std::vector<OffsetRow>& of_one_calibration = {});
nlohmann::ordered_json offset_json(const std::vector<OffsetRow>& rows);

}  // namespace wheelwright::tools

#include "tools/wheelwright/evaluation/offset_table.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/catch.hpp"
#include "tools/wheelwright/evaluation/end_point_plot.hpp"

using namespace wheelwright;
using tools::AttemptOutcome;

namespace {

// Attempts whose every candidate ends this far from the start, in any direction.
std::vector<AttemptOutcome> attempts_that_end(double factor_of_published, std::size_t count) {
  std::vector<AttemptOutcome> outcomes(count);
  for (std::size_t attempt = 0; attempt < count; ++attempt) {
    for (std::size_t i = 0; i < tools::candidates.size(); ++i) {
      const auto& published = tools::candidates.at(i).published;
      const double offset_m = factor_of_published * (published ? published->mean_m : 0.1);
      const double direction = static_cast<double>(attempt);
      outcomes[attempt].at(i) = tools::DriveOutcome{
          Pose{offset_m * std::cos(direction), offset_m * std::sin(direction), 0.0}, {}, {}};
    }
  }
  return outcomes;
}

}  // namespace

TEST_CASE("A published row is met up to 30 % above its mean offset and not beyond") {
  CHECK(all_met(tools::offset_rows(attempts_that_end(1.29, 4), 1)));
  CHECK(all_met(tools::offset_rows(attempts_that_end(0.2, 4), 1)));
  for (const auto& row : tools::offset_rows(attempts_that_end(1.31, 4), 1)) {
    if (row.candidate.published) CHECK(row.met == false);
  }
}

TEST_CASE("A row with an attempt that did not come to its end is not met, and says why") {
  auto outcomes = attempts_that_end(1.0, 4);
  outcomes[2].front() = tools::DriveOutcome{std::nullopt, "stopped: bump", {}};
  const auto rows = tools::offset_rows(outcomes, 1);
  CHECK(rows.front().finished == 3);
  CHECK(rows.front().met == false);
  CHECK(rows.back().met.value_or(true));
  std::ostringstream out;
  print_offset_table(out, rows);
  CHECK_THAT(out.str(), ContainsSubstring("only 3 of 4 attempts came to their end") &&
                            ContainsSubstring("stopped: bump"));
}

TEST_CASE("The table shows each model with its intervals beside the published row") {
  std::ostringstream out;
  print_offset_table(out, tools::offset_rows(attempts_that_end(1.0, 4), 1));
  CHECK_THAT(out.str(), ContainsSubstring("mean offset [m]") && ContainsSubstring("odometry") &&
                            ContainsSubstring("0.068 [0.068, 0.068]") &&
                            ContainsSubstring("0.332 +- 0.095") && ContainsSubstring("0.258 +- 0.021"));
}

TEST_CASE("A table of attempts that all failed has dashes and no numbers") {
  std::vector<AttemptOutcome> outcomes(2);
  for (auto& outcome : outcomes) outcome.fill(tools::DriveOutcome{std::nullopt, "stopped: bump", {}});
  const auto rows = tools::offset_rows(outcomes, 1);
  CHECK_FALSE(rows.front().offset);
  CHECK_FALSE(tools::offset_json(rows)["odometry"].contains("mean_offset"));
  std::ostringstream out;
  print_offset_table(out, rows);
  CHECK_THAT(out.str(), ContainsSubstring("only 0 of 2"));
}

TEST_CASE("A single attempt shows its offset with a dash for what one attempt cannot show") {
  std::ostringstream out;
  const auto rows = tools::offset_rows(attempts_that_end(1.0, 1), 1);
  print_offset_table(out, rows);
  CHECK_THAT(out.str(), ContainsSubstring("0.068 [-]") && !ContainsSubstring("0.068, "));
  const auto json = tools::offset_json(rows)["odometry"];
  CHECK(json.at("mean_offset").at("ci95").is_null());
  CHECK_FALSE(json.contains("standard_deviation"));
}

TEST_CASE("A candidate that was left out has no row") {
  auto outcomes = attempts_that_end(1.0, 2);
  for (auto& outcome : outcomes) outcome.back().reset();
  const auto rows = tools::offset_rows(outcomes, 1);
  CHECK(rows.size() == tools::candidates.size() - 1);
  CHECK_FALSE(tools::offset_json(rows).contains(tools::candidates.back().key));
}

TEST_CASE("End points are listed by model and attempt, without those that failed") {
  auto outcomes = attempts_that_end(1.0, 2);
  outcomes[0].front() = tools::DriveOutcome{std::nullopt, "stopped: bump", {}};
  const std::string csv = tools::end_points_csv(outcomes);
  CHECK(csv.starts_with("model,attempt,x,y,theta,estimate_x,"));
  CHECK_THAT(csv, ContainsSubstring("\nfir,0,0.332000,0.000000,0.000000,"));
}

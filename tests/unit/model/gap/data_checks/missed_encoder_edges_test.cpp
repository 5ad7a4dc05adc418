#include "model/gap/data_checks/missed_encoder_edges.hpp"

#include <algorithm>
#include <cmath>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> runs_with(const std::string& name, test::Severity severity = test::Severity::large) {
  test::GapCaseSpec spec;
  spec.name = name;
  spec.severity = severity;
  spec.runs = 3;
  spec.seconds = 60.0;
  return test::make_gap_case(spec).runs;
}

// Rows in the middle of segments of 0.9 s at one forward command.
std::vector<std::size_t> steady_rows(const DriveLog& log) {
  std::vector<std::size_t> rows;
  std::size_t steady = 0;
  for (std::size_t i = 1; i < log.samples.size(); ++i) {
    const auto& u = log.samples[i].command_m_s;
    const auto& before = log.samples[i - 1].command_m_s;
    const bool same = u.left == before.left && u.right == before.right;
    steady = same && std::min(u.left, u.right) > 0.1 ? steady + 1 : 0;
    if (steady == 50) rows.push_back(i - 25);
  }
  return rows;
}

// Takes a share of the left counts of some rows away, for good.
void lose(DriveLog& log, std::size_t first, std::size_t rows, double share) {
  std::int64_t lost = 0;
  double owed = 0.0;
  for (std::size_t i = first; i < log.samples.size(); ++i) {
    if (i < first + rows) {
      const auto came = log.samples[i].ticks->left - lost - log.samples[i - 1].ticks->left;
      owed += share * static_cast<double>(came);
    }
    const auto now = static_cast<std::int64_t>(std::lround(owed));
    lost += now;
    owed -= static_cast<double>(now);
    log.samples[i].ticks->left -= lost;
  }
}

std::size_t found_in(const DriveLog& log) {
  const std::vector<char> none(log.samples.size(), 0);
  return find_missed_encoder_edges(log, none, true).size() +
         find_missed_encoder_edges(log, none, false).size();
}

}  // namespace

TEST_CASE("A stretch in which a counter misses most of its edges is found where it is, and by how much") {
  auto log = runs_with("clean").front();
  const auto rows = steady_rows(log);
  REQUIRE(rows.size() >= 2);
  lose(log, rows[0], 18, 0.7);
  lose(log, rows[1], 18, 0.5);
  const std::vector<char> none(log.samples.size(), 0);
  const auto found = find_missed_encoder_edges(log, none, true);
  REQUIRE(found.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(std::abs(static_cast<double>(found[i].first_row) - static_cast<double>(rows[i])) <= 2.0);
    CHECK(std::abs(static_cast<double>(found[i].last_row) - static_cast<double>(rows[i] + 17)) <= 2.0);
  }
  CHECK_THAT(found[0].lost, WithinAbs(0.7, 0.08));
  CHECK_THAT(found[1].lost, WithinAbs(0.5, 0.08));
  CHECK(find_missed_encoder_edges(log, none, false).empty());

  const auto gated = gate(log);
  CHECK(gated.dropouts.size() == 2);
  CHECK(gated.flags.counts.at(rows[0] + 5) == 1);
  REQUIRE_FALSE(gated.faults.empty());
  CHECK_THAT(gated.faults.front().what, ContainsSubstring("ticks_left miss"));
}

TEST_CASE("One such stretch in a run may be a wheel that something held, and is left alone") {
  auto log = runs_with("clean").front();
  lose(log, steady_rows(log).front(), 18, 0.7);
  CHECK(gate(log).dropouts.empty());
}

TEST_CASE("No effect that slows wheels down is taken for missed edges") {
  for (const char* name : {"clean", "rate_limit", "stiction", "dead_zone", "coulomb_friction", "backlash",
                           "saturation", "asymmetric_response", "floor_slope", "surface_patch",
                           "transport_delay", "wheel_eccentricity", "command_quantization"}) {
    for (const DriveLog& log : runs_with(name)) {
      INFO(name);
      CHECK(found_in(log) == 0);
    }
  }
}

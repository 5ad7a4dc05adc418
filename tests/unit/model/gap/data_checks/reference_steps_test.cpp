#include <algorithm>
#include <string>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> runs_hiding(const std::string& hidden) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = test::Severity::large;
  spec.channels = test::Channels::ticks_ref;
  spec.seed = 21;
  spec.runs = 2;
  spec.seconds = 40.0;
  return test::make_gap_case(spec).runs;
}

// From a row on, all poses lie elsewhere.
void match_map_again(DriveLog& run, std::size_t row, double by_m) {
  for (std::size_t i = row; i < run.samples.size(); ++i) *run.samples[i].reference_y_m += by_m;
}

std::vector<std::string> steps_said(const std::vector<DriveLog>& runs) {
  std::vector<std::string> said;
  for (const GatedLog& gated : gate_together(runs)) {
    for (const DataFault& fault : gated.faults) {
      if (fault.what.find("the reference steps") == 0) said.push_back(fault.text());
    }
  }
  return said;
}

}  // namespace

TEST_CASE("A reference that steps to places where the wheels did not go is said, with number and size") {
  auto runs = runs_hiding("clean");
  for (const std::size_t row : {400UL, 900UL, 1500UL})
    match_map_again(runs.front(), row, row == 900 ? -0.04 : 0.03);
  const auto said = steps_said(runs);
  REQUIRE(said.size() == 1);
  CHECK(said.front().find("steps 3 times by up to 0.04") != std::string::npos);
}

TEST_CASE("A robot that is pushed once while it drives is said, and the free run starts again behind it") {
  auto runs = runs_hiding("clean");
  constexpr std::size_t pushed_row = 900;
  match_map_again(runs.front(), pushed_row, 0.06);
  const auto said = steps_said(runs);
  REQUIRE(said.size() == 1);
  CHECK(said.front().find("once, by 0.0") != std::string::npos);
  const auto gated = gate_together(runs);
  CHECK(std::ranges::count(gated.front().flags.restart, 1) == 1);
  CHECK(std::ranges::count(gated.back().flags.restart, 1) == 0);
}

TEST_CASE("No motion that a robot can make beyond its wheels is a step of its reference") {
  for (const auto& effect : test::hidden_effects()) {
    INFO(effect.name);
    CHECK(steps_said(runs_hiding(std::string(effect.name))).empty());
  }
}

#include "model/log/reference_response.hpp"

#include <cmath>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/smoothed_reference.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> case_runs(const std::string& hidden, std::uint64_t seed, test::Program program) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.program = program;
  spec.severity = test::Severity::large;
  spec.channels = test::Channels::ticks_ref;
  spec.seed = seed;
  spec.runs = 3;
  spec.seconds = 60.0;
  return test::make_gap_case(spec).runs;
}

std::vector<DriveLog> smoothed_case_runs(const std::string& hidden, std::uint64_t seed) {
  return case_runs(hidden, seed, test::Program::mixed);
}

void filter_all(std::vector<DriveLog>& runs, const test::Filter& position, const test::Filter& heading) {
  for (DriveLog& run : runs) test::filter_reference(run, position, heading);
}

std::optional<ReferenceResponse> response_of(const std::vector<DriveLog>& runs) {
  std::vector<const DriveLog*> pointers;
  for (const DriveLog& run : runs) pointers.push_back(&run);
  return find_reference_response(pointers);
}

}  // namespace

TEST_CASE("No effect that a robot can have is taken for a reference that smooths") {
  for (const auto& effect : test::hidden_effects()) {
    INFO(effect.name);
    CHECK_FALSE(response_of(smoothed_case_runs(std::string(effect.name), 3)).has_value());
  }
}

TEST_CASE("A reference that only comes late is left to the fit of the model") {
  auto runs = smoothed_case_runs("clean", 5);
  filter_all(runs, test::delayed(0.15), test::delayed(0.15));
  CHECK_FALSE(response_of(runs).has_value());
}

TEST_CASE("The delay and the width of a smoothing are found, whatever its form") {
  struct Smoothing {
    const char* name;
    test::Filter filter;
    double delay_s;
    double width_s;
  };
  const std::vector<Smoothing> smoothings{{"low-pass", test::low_pass(0.15), 0.15, 0.15},
                                          {"moving mean", test::moving_mean(0.5), 0.25, 0.144},
                                          {"both ways", test::both_ways(0.1), 0.0, 0.141}};
  for (const auto& smoothing : smoothings) {
    for (const char* hidden : {"clean", "turn_scrub", "lever_arm"}) {
      INFO(smoothing.name << " " << hidden);
      auto runs = smoothed_case_runs(hidden, 7);
      filter_all(runs, smoothing.filter, smoothing.filter);
      const auto response = response_of(runs);
      REQUIRE(response.has_value());
      for (const DelayKernel* kernel : {&response->position, &response->heading}) {
        CHECK_THAT(kernel->mean_s(), WithinAbs(smoothing.delay_s, 0.02));
        CHECK_THAT(kernel->width_s(), WithinAbs(smoothing.width_s, 0.04));
      }
    }
  }
}

TEST_CASE("A heading that comes later than the place is found") {
  auto runs = smoothed_case_runs("clean", 9);
  filter_all(runs, {}, test::delayed(0.1));
  const auto response = response_of(runs);
  REQUIRE(response.has_value());
  CHECK_THAT(response->heading.mean_s() - response->position.mean_s(), WithinAbs(0.1, 0.02));
}

TEST_CASE("A heading that no command turns says nothing of when the reference comes") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    INFO(seed);
    auto runs = case_runs("wheel_scale_mismatch", seed, test::Program::straight_only);
    CHECK_FALSE(response_of(runs).has_value());
    filter_all(runs, test::low_pass(0.15), test::low_pass(0.15));
    const auto response = response_of(runs);
    REQUIRE(response.has_value());
    CHECK_THAT(response->position.mean_s(), WithinAbs(0.15, 0.02));
    CHECK(response->heading.weights.empty());
  }
}

TEST_CASE("The data gate says that a reference smooths, once for all runs") {
  auto runs = smoothed_case_runs("clean", 11);
  filter_all(runs, test::low_pass(0.2), test::low_pass(0.2));
  const auto gated = gate_together(runs);
  std::size_t said = 0;
  for (const GatedLog& log : gated) {
    CHECK_FALSE(log.log.reference_response.is_immediate());
    for (const DataFault& fault : log.faults) {
      if (fault.text().find("does not show the robot at once") == std::string::npos) continue;
      ++said;
      CHECK(fault.text().find("in 3 runs") != std::string::npos);
    }
  }
  CHECK(said == 1);
}

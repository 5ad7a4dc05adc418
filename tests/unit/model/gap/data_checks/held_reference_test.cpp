// References that are written more often than they come.
#include <algorithm>

#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> clean_runs() {
  test::GapCaseSpec spec;
  spec.name = "clean";
  spec.runs = 3;
  spec.seconds = 40.0;
  return test::make_gap_case(spec).runs;
}

// As of a tracker that is asked on every row and has something new on each fifth.
void hold_poses(DriveLog& log) {
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    const DriveSample& told = log.samples[row - row % 5];
    log.samples[row].reference_x_m = told.reference_x_m;
    log.samples[row].reference_y_m = told.reference_y_m;
    log.samples[row].reference_theta_rad = told.reference_theta_rad;
  }
}

}  // namespace

TEST_CASE("Poses that are repeated until the next one are no readings") {
  DriveLog log = clean_runs().front();
  CHECK(gate(log).faults.empty());
  hold_poses(log);
  const GatedLog gated = gate(log);
  REQUIRE(gated.faults.size() == 1);
  CHECK_THAT(gated.faults.front().what,
             ContainsSubstring("repeats its last pose until the next one, 0.09 s later"));
  CHECK_FALSE(gated.faults.front().explains);
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    if (gated.log.samples[row].reference_x_m) CHECK(row % 5 == 0);
  }
}

TEST_CASE("Nothing is missing from a robot whose reference is repeated") {
  auto runs = clean_runs();
  for (auto& run : runs) hold_poses(run);
  const auto analysis = analyse_gap(runs, {}, {}, serial_for, [](const std::string&, double) {});
  REQUIRE(analysis);
  INFO(analysis->summary);
  CHECK(analysis->verdict == Verdict::nothing_missing);
}

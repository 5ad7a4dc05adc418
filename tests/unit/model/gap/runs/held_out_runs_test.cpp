// Which runs an analysis is confirmed on.
#include <algorithm>

#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> runs_with(const std::string& name, int count, double seconds = 28.0) {
  test::GapCaseSpec spec;
  spec.name = name;
  spec.severity = test::Severity::large;
  spec.runs = count;
  spec.seconds = seconds;
  spec.period_s = 0.03;
  auto runs = test::make_gap_case(spec).runs;
  for (auto& run : runs) run.name = name + "_" + run.name;
  return runs;
}

// The same drive in another room.
DriveLog elsewhere(DriveLog run) {
  for (DriveSample& sample : run.samples) {
    if (sample.reference_x_m) *sample.reference_x_m += 20.0;
  }
  return run;
}

GapAnalysis analysed(const std::vector<DriveLog>& train, const std::vector<DriveLog>& test) {
  auto analysis = analyse_gap(train, test, {}, serial_for, [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

}  // namespace

TEST_CASE("What no held-out run could show is confirmed on one of the others in which it shows") {
  auto train = runs_with("surface_patch", 3);
  const auto clean = runs_with("clean", 2);
  train.push_back(elsewhere(clean[0]));
  const auto analysis = analysed(train, {elsewhere(clean[1])});
  INFO(analysis.summary);
  REQUIRE_FALSE(analysis.found.empty());
  CHECK(analysis.found.front().setting.name == "surface_patch");
  REQUIRE(analysis.held_out.size() == 1);
  CHECK_THAT(analysis.held_out.front(), ContainsSubstring("surface_patch_"));
  CHECK_THAT(analysis.summary, ContainsSubstring("was held out in their place"));
  CHECK(analysis.train_runs == 3);
  CHECK(analysis.untouched);
}

TEST_CASE("A name that takes untouched runs further away is withdrawn, and the summary says so") {
  const auto train = runs_with("surface_patch", 3, 40.0);
  const auto analysis = analysed(train, {runs_with("clean", 2, 40.0).back()});
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::unnamed);
  CHECK(analysis.found.empty());
  CHECK(analysis.after.effects.empty());
  CHECK_THAT(analysis.summary, ContainsSubstring("The other runs look like surface_patch"));
}

TEST_CASE("Test runs beside three training runs take no part in the choice, and the figures are theirs") {
  const auto train = runs_with("saturation", 3);
  auto last = runs_with("saturation", 4);
  last.erase(last.begin(), last.begin() + 3);
  last.front().name = "last";
  const auto analysis = analysed(train, last);
  INFO(analysis.summary);
  CHECK(analysis.untouched);
  CHECK(analysis.tested == std::vector<std::string>{"last"});
  CHECK(analysis.held_out == std::vector<std::string>{train.back().name});
  CHECK(analysis.trained == std::vector<std::string>{train[0].name, train[1].name});
  REQUIRE_FALSE(analysis.found.empty());
  CHECK(analysis.found.front().setting.name == "saturation");
  CHECK(analysis.found.front().test_gain_nats.value() > 10.0);
  CHECK(analysis.test.after.distance_rms_m.value() < 0.5 * analysis.test.before.distance_rms_m.value());
}

TEST_CASE("The last of four runs is kept untouched") {
  const auto analysis = analysed(runs_with("clean", 4), {});
  CHECK(analysis.untouched);
  CHECK(analysis.tested.size() == 1);
  CHECK(analysis.train_runs == 2);
  CHECK(analysis.test_runs == 1);
  CHECK(analysis.check.passed);
}

TEST_CASE("Where nothing shows the runs that were given are the ones that were held out") {
  auto runs = runs_with("clean", 3);
  const std::vector<DriveLog> held_out{runs.back()};
  runs.pop_back();
  const auto analysis = analysed(runs, held_out);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK(analysis.held_out == std::vector<std::string>{held_out.front().name});
}

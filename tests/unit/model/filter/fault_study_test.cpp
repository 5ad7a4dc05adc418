// The fault study in short: forty faults on the simulated robot, one seed each.
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/fault_scenario.hpp"

using namespace wheelwright;

TEST_CASE("Faults that would move the pose are found, named and kept out of it") {
  const RobotModel model = test::calibrated_model("default", "box", 77);
  int harmful = 0;
  int found = 0;
  int right = 0;
  double by_fault_m = 0.0;
  double left_m = 0.0;
  for (int kind = 0; kind < test::injection_count; ++kind) {
    for (std::uint64_t i = 0; i < 4; ++i) {
      const auto what = static_cast<test::Injection>(kind);
      const std::uint64_t seed = 500 + 10 * static_cast<std::uint64_t>(kind) + i;
      const auto plan = test::random_fault(what, seed);
      const auto outcome = test::run_fault(model, test::robot_on_endless_floor("default", seed), plan, seed);
      INFO(test::name_of(what) << ", seed " << seed << ", harm " << outcome.harm_m << " m, named "
                               << name_of(outcome.named));
      CHECK(outcome.false_alarms == 0);
      if (outcome.harm_m <= 0.02) continue;
      ++harmful;
      CHECK(outcome.found);
      found += outcome.found ? 1 : 0;
      right += outcome.named == test::right_name(what) ? 1 : 0;
      if (what == test::Injection::stall || what == test::Injection::lift) continue;
      by_fault_m += outcome.harm_m;
      left_m += outcome.hybrid_left_m;
    }
  }
  CHECK(harmful >= 30);
  CHECK(found == harmful);
  CHECK(right >= 0.95 * harmful);
  CHECK(left_m < 0.05 * by_fault_m);
}

// A call is chance: of 96 quarter hours of this kind one had one.
TEST_CASE("Two hours of clean driving give no alarm and at most one call for a recalibration") {
  int calls = 0;
  for (std::uint64_t seed = 201; seed <= 208; ++seed) {
    const RobotModel model = test::calibrated_model("default", "furniture", seed);
    const auto drive = test::record_drive(test::robot_on_endless_floor("default", seed), seed + 1, 900.0);
    HybridFilter filter(model);
    for (const SensorFrame& frame : drive.frames) {
      const HybridOutput out = filter.step(frame);
      INFO("seed " << seed << ", tick " << out.tick);
      REQUIRE(out.events.empty());
      if (out.raised_recalibration) ++calls;
    }
  }
  CHECK(calls <= 1);
}

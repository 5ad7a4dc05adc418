// Numbers that people state of a robot, against its reference.
#include "model/gap/data_checks/wrong_reference.hpp"

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/reference_by_counts.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

DriveLog counted_drive() {
  test::GapCaseSpec spec;
  spec.runs = 1;
  spec.seconds = 20.0;
  return test::by_counts(test::make_gap_case(spec).runs.front());
}

}  // namespace

TEST_CASE(
    "A wheel base and a distance of a count that are wrong by half are bad data, with the value that would "
    "agree") {
  const DriveLog log = counted_drive();
  REQUIRE(gate(log).faults.empty());
  const auto only_fault = [](const DriveLog& of) {
    const auto gated = gate(of);
    REQUIRE(gated.faults.size() == 1);
    CHECK(gated.faults.front().explains);
    return gated.faults.front().what;
  };
  DriveLog wide = log;
  wide.wheel_base_m *= 2.0;
  CHECK_THAT(only_fault(wide), ContainsSubstring("turns 2 times as far as the counts say") &&
                                   ContainsSubstring("one of 0.258 m would agree"));
  DriveLog coarse = log;
  coarse.metres_per_tick = WheelPair{2.0 * log.metres_per_tick->left, 2.0 * log.metres_per_tick->right};
  CHECK_THAT(only_fault(coarse), ContainsSubstring("moves 0.5 times as far as the counts say"));
  DriveLog one_wheel = log;
  one_wheel.metres_per_tick->right *= 2.0;
  CHECK_THAT(only_fault(one_wheel),
             ContainsSubstring("the right wheel rolls 0.5 times as far as its counts say"));
}

TEST_CASE("What a robot slips is an effect, and no wrong wheel base or distance of a count") {
  DriveLog log = counted_drive();
  log.metres_per_tick->left *= 0.85;
  log.metres_per_tick->right *= 1.15;
  log.wheel_base_m *= 0.6;
  CHECK(gate(log).faults.empty());
}

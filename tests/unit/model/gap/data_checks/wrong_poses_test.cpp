#include "model/gap/data_checks/wrong_poses.hpp"

#include <string>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

DriveLog tracked_run(test::Channels channels = test::Channels::ticks_ref) {
  test::GapCaseSpec spec;
  spec.runs = 1;
  spec.seconds = 40.0;
  spec.channels = channels;
  return test::make_gap_case(spec).runs.front();
}

// A row of which the 60 behind it go some way.
std::size_t driving_row(const DriveLog& log) {
  for (std::size_t row = 300; row + 100 < log.samples.size(); ++row) {
    const DriveSample& from = log.samples[row];
    const DriveSample& to = log.samples[row + 60];
    if (std::hypot(*to.reference_x_m - *from.reference_x_m, *to.reference_y_m - *from.reference_y_m) > 0.25)
      return row;
  }
  FAIL("the run holds no drive");
  return 0;
}

void set_pose(DriveSample& sample, const Pose& pose) {
  sample.reference_x_m = pose.x_m;
  sample.reference_y_m = pose.y_m;
  sample.reference_theta_rad = pose.theta_rad;
}

// The rows have lost their poses, those around them have not, and one fault says it.
void check_left_out(const DriveLog& log, std::size_t begin, std::size_t end, const std::string& words) {
  const GatedLog gated = gate(log);
  for (std::size_t row = begin; row < end; ++row) {
    INFO(row);
    CHECK_FALSE(gated.log.samples[row].reference_pose());
  }
  CHECK(gated.log.samples[begin - 1].reference_pose());
  CHECK(gated.log.samples[end].reference_pose());
  REQUIRE(gated.faults.size() == 1);
  CHECK_THAT(gated.faults.front().text(), ContainsSubstring(words));
}

}  // namespace

TEST_CASE("Zeros in place of a pose are left out of a drive log") {
  DriveLog log = tracked_run();
  const std::size_t row = driving_row(log);
  for (DriveSample& sample : log.samples) {  // away from the origin
    *sample.reference_x_m += 2.0;
    *sample.reference_y_m += 3.0;
  }
  for (std::size_t i = row; i < row + 25; ++i) set_pose(log.samples[i], {});
  check_left_out(log, row, row + 25, "where x and y are both 0; 25 poses were left out");
}

TEST_CASE("A pose that is held while the robot goes on is left out, but for the first") {
  DriveLog log = tracked_run();
  const std::size_t row = driving_row(log);
  for (std::size_t i = row + 1; i < row + 60; ++i)
    set_pose(log.samples[i], *log.samples[row].reference_pose());
  check_left_out(log, row + 1, row + 60, "holds its last pose and then jumps");
}

TEST_CASE("The pose of another robot for a second is left out up to the jump back, with counts and without") {
  for (const auto channels : {test::Channels::ticks_ref, test::Channels::ref}) {
    DriveLog log = tracked_run(channels);
    const std::size_t row = driving_row(log);
    for (std::size_t i = row; i < row + 55; ++i) {
      const Pose pose = *log.samples[i].reference_pose();
      set_pose(log.samples[i], {pose.x_m + 1.2, pose.y_m - 0.7, pose.theta_rad + 2.0});
    }
    check_left_out(log, row, row + 55, "it jumps back");
  }
}

TEST_CASE("Single poses that lie beside the others are left out") {
  DriveLog log = tracked_run(test::Channels::ref);
  const std::size_t row = driving_row(log);
  *log.samples[row].reference_x_m += 0.06;
  check_left_out(log, row, row + 1, "lie beside those before and after");
}

TEST_CASE("A robot that was carried elsewhere keeps its poses from there on") {
  DriveLog log = tracked_run();
  const std::size_t row = driving_row(log);
  for (std::size_t i = row; i < log.samples.size(); ++i) *log.samples[i].reference_x_m += 1.5;
  const GatedLog gated = gate(log);
  CHECK(gated.log.samples[row + 10].reference_pose());
  CHECK(gated.log.samples.back().reference_pose());
}

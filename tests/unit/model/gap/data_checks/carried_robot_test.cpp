// Robots that somebody lifts in the midst of a run.
#include "model/gap/data_checks/carried_robot.hpp"

#include <cstddef>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/reference_by_counts.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr std::size_t rest_rows = 150;

// A drive, and the same drive once more behind a rest of so many rows.
struct DriveWithRest {
  DriveLog log;
  std::size_t rest = 0;  // its first row
};

DriveWithRest drive_with_rest() {
  test::GapCaseSpec spec;
  spec.runs = 1;
  spec.seconds = 20.0;
  DriveWithRest drive{test::make_gap_case(spec).runs.front()};
  DriveLog& log = drive.log;
  const auto first = log.samples;
  drive.rest = first.size();
  const DriveSample last = first.back();
  const double period_s = first[1].t_s - first[0].t_s;
  for (std::size_t i = 0; i < rest_rows + first.size(); ++i) {
    DriveSample sample = last;
    sample.command_m_s = {};
    if (i >= rest_rows) {
      const DriveSample& again = first[i - rest_rows];
      sample = again;
      sample.ticks->left += last.ticks->left - first[0].ticks->left;
      sample.ticks->right += last.ticks->right - first[0].ticks->right;
    }
    sample.t_s = last.t_s + period_s * static_cast<double>(i + 1);
    log.samples.push_back(sample);
  }
  log.extra_columns.clear();
  log = test::by_counts(std::move(log));
  return drive;
}

// Moved from the middle of the rest on, in a second.
DriveLog carried(const DriveWithRest& drive, double metres) {
  DriveLog log = drive.log;
  const double from_s = log.samples[drive.rest + rest_rows / 2].t_s;
  for (auto& sample : log.samples)
    if (sample.t_s > from_s) *sample.reference_x_m += metres * std::min(1.0, sample.t_s - from_s);
  return log;
}

}  // namespace

TEST_CASE("A robot that is carried while its wheels stand is said, and what follows starts again") {
  const DriveWithRest drive = drive_with_rest();
  CHECK(gate(drive.log).faults.empty());
  const GatedLog gated = gate(carried(drive, 0.8));
  REQUIRE(gated.faults.size() == 1);
  const DataFault& fault = gated.faults.front();
  CHECK_THAT(fault.what, ContainsSubstring("moves 0.8 m") && ContainsSubstring("carried or pushed"));
  CHECK_FALSE(fault.explains);
  CHECK(fault.row - drive.log.first_line > drive.rest + rest_rows / 2 - 2);
  CHECK(fault.row - drive.log.first_line < drive.rest + rest_rows / 2 + 20);
  CHECK(gated.flags.restart[drive.rest + rest_rows / 2 + 10] != 0);
  CHECK(gated.flags.restart[drive.rest + rest_rows + 60] == 0);
}

TEST_CASE("A robot that is carried is seen by its commands where no wheels are counted") {
  DriveLog log = carried(drive_with_rest(), 0.8);
  log.metres_per_tick.reset();
  for (auto& sample : log.samples) sample.ticks.reset();
  const GatedLog gated = gate(log);
  REQUIRE(gated.faults.size() == 1);
  CHECK_THAT(gated.faults.front().what, ContainsSubstring("stand by their commands"));
}

TEST_CASE("A pose that trembles by two centimetres while the robot stands carries nobody") {
  DriveLog log = drive_with_rest().log;
  for (std::size_t i = 0; i < log.samples.size(); ++i)
    *log.samples[i].reference_x_m += i % 7 == 0 ? 0.02 : 0.0;
  for (const DataFault& fault : gate(log).faults) CHECK(fault.what.find("carried") == std::string::npos);
}

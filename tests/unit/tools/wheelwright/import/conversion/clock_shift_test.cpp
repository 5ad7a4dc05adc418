// Clocks of two machines, one of which goes fast.
#include "tools/wheelwright/import/conversion/clock_shift.hpp"

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

// A drive of 90 s whose speeds never come again.
ForeignDrive drive_without_period() {
  const auto wave = [](std::size_t k, double period_rows) {
    return std::sin(6.283185307 * static_cast<double>(k) / period_rows);
  };
  return drive_by([&](std::size_t k) { return 0.12 + 0.08 * wave(k, 61.0) + 0.05 * wave(k, 23.7); },
                  [&](std::size_t k) { return 0.11 - 0.06 * wave(k, 47.0) + 0.06 * wave(k, 131.0); }, 1800);
}

// A drive, and its poses by a clock that shows `rate` seconds in one of the robot's, and 12.3 s at its start.
ImportOutcome import_with_clock(const ForeignDrive& drive, double rate) {
  const auto log =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row);
      });
  const auto poses = foreign_text(drive, "t,x,y,theta", [&](const ForeignRow& row) {
    return number(12.3 + rate * row.t_s) + "," + number(row.x) + "," + number(row.y) + "," +
           number(row.theta);
  });
  auto understood = import::understand(
      {{file_of("drive.csv", log)},
       file_of("mocap.csv", poses),
       import::GivenMapping("", {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"})});
  if (!understood) FAIL(understood.error());
  auto conversion = import::to_runs(*understood);
  if (!conversion) FAIL(conversion.error());
  return {std::move(*understood), std::move(conversion)};
}

double largest_error_m(const ImportOutcome& outcome, const ForeignDrive& drive) {
  double largest = 0.0;
  const auto& samples = outcome.conversion->runs.front().samples;
  for (std::size_t k = 40; k + 40 < samples.size(); ++k) {
    if (!samples[k].reference_pose()) continue;
    largest = std::max(largest, std::hypot(samples[k].reference_pose()->x_m - drive.rows[k].x,
                                           samples[k].reference_pose()->y_m - drive.rows[k].y));
  }
  return largest;
}

}  // namespace

TEST_CASE(
    "A clock of the reference that is half a percent fast is found, and the poses are where they were") {
  const ForeignDrive drive = drive_without_period();
  const ImportOutcome outcome = import_with_clock(drive, 1.005);
  REQUIRE(outcome.understood.mapping.reference->clock_rate);
  CHECK_THAT(*outcome.understood.mapping.reference->clock_rate, WithinAbs(1.0 / 1.005, 3e-4));
  CHECK_THAT(*outcome.understood.mapping.reference->shift_s, WithinAbs(-12.3, 0.06));
  CHECK(outcome.found("is fast by 0.5"));
  CHECK(largest_error_m(outcome, drive) < 0.02);
}

TEST_CASE("Clocks that go alike are shifted and no more") {
  const ForeignDrive drive = drive_without_period();
  const ImportOutcome outcome = import_with_clock(drive, 1.0);
  CHECK_FALSE(outcome.understood.mapping.reference->clock_rate);
  CHECK(largest_error_m(outcome, drive) < 0.02);
}

TEST_CASE("A rate that a person states is used") {
  const ForeignDrive drive = foreign_drive(600);
  const std::string text =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row);
      });
  const std::string poses = foreign_text(drive, "t,x,y,theta", [](const ForeignRow& row) {
    return number(2.0 * row.t_s) + "," + number(row.x) + "," + number(row.y) + "," + number(row.theta);
  });
  const auto understood = import::understand(
      {{file_of("drive.csv", text)},
       file_of("mocap.csv", poses),
       import::GivenMapping("", {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005",
                                 "reference.clock=same", "reference.clock_rate=0.5"})});
  REQUIRE(understood);
  const auto conversion = import::to_runs(*understood);
  REQUIRE(conversion);
  const auto& sample = conversion->runs.front().samples[300];
  REQUIRE(sample.reference_pose());
  CHECK_THAT(sample.reference_pose()->x_m, WithinAbs(drive.rows[300].x, 0.02));
}

TEST_CASE("A shift of minutes between long records is as fine as one of seconds") {
  const auto wave = [](std::size_t k, double period_rows) {
    return std::sin(6.283185307 * static_cast<double>(k) / period_rows);
  };
  const ForeignDrive drive =
      drive_by([&](std::size_t k) { return 0.12 + 0.08 * wave(k, 61.3) + 0.05 * wave(k, 237.1); },
               [&](std::size_t k) { return 0.11 - 0.06 * wave(k, 47.9) + 0.06 * wave(k, 1310.7); }, 12'000);
  constexpr double begun_later_s = 250.0;
  const auto log =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row);
      });
  std::string poses = "t,x,y,theta\n";
  for (const ForeignRow& row : drive.rows)
    if (row.t_s >= begun_later_s)
      poses += number(row.t_s - begun_later_s) + "," + number(row.x) + "," + number(row.y) + "," +
               number(row.theta) + "\n";
  const auto understood = import::understand(
      {{file_of("drive.csv", log)},
       file_of("mocap.csv", poses),
       import::GivenMapping("", {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"})});
  if (!understood) FAIL(understood.error());
  CHECK_THAT(*understood->mapping.reference->shift_s, WithinAbs(begun_later_s, 0.06));
}

TEST_CASE("Without wheels the commands of both sides say how fast the robot goes") {
  const auto wave = [](std::size_t k, double period_rows) {
    return std::sin(6.283185307 * static_cast<double>(k) / period_rows);
  };
  const ForeignDrive drive =
      drive_by([](std::size_t) { return 0.1; },
               [&](std::size_t k) { return 0.11 - 0.06 * wave(k, 147.9) + 0.06 * wave(k, 310.7); });
  const auto log = foreign_text(drive, "t,cmd_left,cmd_right", [](const ForeignRow& row) {
    return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right);
  });
  const auto poses = foreign_text(drive, "t,x,y,theta", [](const ForeignRow& row) {
    return number(7.0 + row.t_s) + "," + number(row.x) + "," + number(row.y) + "," + number(row.theta);
  });
  const auto understood = import::understand({{file_of("drive.csv", log)},
                                              file_of("mocap.csv", poses),
                                              import::GivenMapping("", {"robot.wheel_base_m=0.3"})});
  if (!understood) FAIL(understood.error());
  CHECK_THAT(*understood->mapping.reference->shift_s,
             WithinAbs(-7.0, 0.4));  // the robot's delay and lag in it
}

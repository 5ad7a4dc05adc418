// Stamps that say when a row arrived, and those of the device; stamps that were put together wrongly.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

TEST_CASE("The clock of the device is taken where the other stamps were given as rows arrived in bunches") {
  const ForeignDrive drive = foreign_drive();
  std::size_t k = 0;
  const auto outcome = import_text(
      foreign_text(drive, "pc_time,mcu_ms,cmd_left,cmd_right,enc_left,enc_right",
                   [&k](const ForeignRow& row) {
                     // Three rows come at once, after the third.
                     const double late_s =
                         0.05 * static_cast<double>(2 - k % 3) + 0.001 * static_cast<double>(k % 3);
                     ++k;
                     return number(1.7e9 + row.t_s + late_s) + "," +
                            std::to_string(std::lround(1e3 * row.t_s)) + "," + number(row.command_left) +
                            "," + number(row.command_right) + "," + counts(row);
                   }),
      {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  check_same(outcome, drive);
  CHECK(outcome.found("come in bunches"));
  CHECK_FALSE(outcome.remarks("taken at even times"));
}

TEST_CASE("Nanoseconds that lost their leading zeros are called so, and nobody is sent to sort the rows") {
  const ForeignDrive drive = foreign_drive(1200, 0.05);
  const auto outcome = import_text(foreign_text(drive, "stamp,cmd_left,cmd_right,enc_left,enc_right",
                                                [](const ForeignRow& row) {
                                                  const long ns = std::lround(1e9 * row.t_s) + 7'000'000;
                                                  return std::to_string(500 + ns / 1'000'000'000) + "." +
                                                         std::to_string(ns % 1'000'000'000) + "," +
                                                         number(row.command_left) + "," +
                                                         number(row.command_right) + "," + counts(row);
                                                }),
                                   {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  REQUIRE_FALSE(outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("without their leading zeros"));
}

TEST_CASE("Whole seconds that many rows share are seconds") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "time,cmd_left,cmd_right,enc_left,enc_right",
                                                [](const ForeignRow& row) {
                                                  return std::to_string(static_cast<long>(row.t_s + 1e-9)) +
                                                         "," + number(row.command_left) + "," +
                                                         number(row.command_right) + "," + counts(row);
                                                }),
                                   {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  REQUIRE(outcome.conversion);
  CHECK_THAT(outcome.conversion->runs.front().samples.back().t_s, WithinAbs(60.0, 1.1));
}

TEST_CASE("Milliseconds of slow rows are found by how fast the wheels would go otherwise") {
  const ForeignDrive drive =
      drive_by([](std::size_t k) { return 0.1 + 0.1 * static_cast<double>(k / 7 % 2); },
               [](std::size_t k) { return 0.1 + 0.1 * static_cast<double>(k / 11 % 2); }, 400, 1.0);
  const auto outcome = import_text(foreign_text(drive, "timestamp,cmd_left,cmd_right,enc_left,enc_right",
                                                [](const ForeignRow& row) {
                                                  return std::to_string(std::lround(1e3 * row.t_s)) + "," +
                                                         number(row.command_left) + "," +
                                                         number(row.command_right) + "," + counts(row);
                                                }),
                                   {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  CHECK(outcome.understood.mapping.time.unit == import::TimeUnit::ms);
  CHECK(outcome.found("time is in milliseconds"));
}

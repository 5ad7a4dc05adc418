// Commands that change at every row, in columns without names.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

std::string wheel_speeds(const ForeignRow& row) {
  return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
         counts(row);
}

}  // namespace

TEST_CASE("A joystick's commands of two wheels are found beside counts") {
  const ForeignDrive drive = joystick_drive();
  const auto outcome = import_text(foreign_text(drive, "", wheel_speeds), {"robot.wheel_base_m=0.3"});
  check_same(outcome, drive);
}

TEST_CASE("A joystick's forward and turning speed are found beside counts") {
  const ForeignDrive drive = joystick_drive();
  const auto outcome = import_text(foreign_text(drive, "",
                                                [](const ForeignRow& row) {
                                                  return number(row.t_s) + "," + number(row.linear()) + "," +
                                                         number(row.angular(0.3)) + "," + counts(row);
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  check_same(outcome, drive);
}

TEST_CASE("Poses beside a joystick's commands are the reference and no commands") {
  const ForeignDrive drive = joystick_drive();
  const auto outcome = import_text(foreign_text(drive, "",
                                                [](const ForeignRow& row) {
                                                  return wheel_speeds(row) + "," + number(row.x) + "," +
                                                         number(row.y) + "," + number(row.theta);
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  check_same(outcome, drive);
  CHECK(outcome.conversion->runs.front().samples.back().reference_x_m.has_value());
}

TEST_CASE("Where a measured speed could be the command as well, a joystick's command is not guessed") {
  const ForeignDrive drive = joystick_drive();
  ForeignRow before = drive.rows.front();
  const auto outcome = import_text(
      foreign_text(drive, "",
                   [&before](const ForeignRow& row) {
                     const auto speed = [&](std::int64_t ForeignRow::*side) {
                       return number(static_cast<double>(row.*side - before.*side) * 0.01);
                     };
                     const std::string fields = wheel_speeds(row) + "," + speed(&ForeignRow::counts_left) +
                                                "," + speed(&ForeignRow::counts_right);
                     before = row;
                     return fields;
                   }),
      {"robot.wheel_base_m=0.3"});
  REQUIRE(!outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("command"));
}

TEST_CASE("Measured speeds beside counts are no commands, as the counts do not follow them") {
  const ForeignDrive drive = joystick_drive();
  ForeignRow before = drive.rows.front();
  const auto outcome = import_text(
      foreign_text(drive, "",
                   [&before](const ForeignRow& row) {
                     const auto speed = [&](std::int64_t ForeignRow::*side) {
                       return number(static_cast<double>(row.*side - before.*side) * 0.01);
                     };
                     const std::string fields = number(row.t_s) + "," + speed(&ForeignRow::counts_left) +
                                                "," + speed(&ForeignRow::counts_right) + "," + counts(row);
                     before = row;
                     return fields;
                   }),
      {"robot.wheel_base_m=0.3"});
  REQUIRE(!outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("no commands"));
}

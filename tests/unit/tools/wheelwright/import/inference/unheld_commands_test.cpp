// Commands that change at every row, in columns without names.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

std::string wheel_speeds(const ForeignRow& row) {
  return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
         counts(row);
}

// The speeds of both wheels by the counts of a row and the one before, in m/s, as two more columns.
class MeasuredSpeeds {
 public:
  explicit MeasuredSpeeds(const ForeignDrive& drive)
      : before_(drive.rows.front()), period_s_(drive.period_s) {}

  std::string next(const ForeignRow& row) {
    const double m_s = ForeignDrive::metres_per_count / period_s_;
    const auto left = static_cast<double>(row.counts_left - before_.counts_left);
    const auto right = static_cast<double>(row.counts_right - before_.counts_right);
    before_ = row;
    std::string columns(",");
    columns += number(left * m_s);
    columns += ",";
    columns += number(right * m_s);
    return columns;
  }

 private:
  ForeignRow before_;
  double period_s_;
};

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
  MeasuredSpeeds measured(drive);
  const auto outcome = import_text(
      foreign_text(drive, "", [&](const ForeignRow& row) { return wheel_speeds(row) + measured.next(row); }),
      {"robot.wheel_base_m=0.3"});
  REQUIRE(!outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("no commands"));
}

TEST_CASE("Measured speeds beside counts are no commands, as the counts do not follow them") {
  const ForeignDrive drive = joystick_drive();
  MeasuredSpeeds measured(drive);
  const auto outcome = import_text(
      foreign_text(
          drive, "",
          [&](const ForeignRow& row) { return number(row.t_s) + measured.next(row) + "," + counts(row); }),
      {"robot.wheel_base_m=0.3"});
  REQUIRE(!outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("no commands"));
}

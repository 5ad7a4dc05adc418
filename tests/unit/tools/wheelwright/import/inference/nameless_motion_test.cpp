// Commands and wheels in columns without names: units, signs and a counter that is silent.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

std::string millimetres(double m_s) {
  return std::to_string(std::lround(1000.0 * m_s));
}

std::string commands_in_millimetres(const ForeignRow& row) {
  return number(row.t_s) + "," + millimetres(row.command_left) + "," + millimetres(row.command_right) + "," +
         counts(row);
}

std::string twist_with_reversed_wheel(const ForeignRow& row, bool left, bool angular_first) {
  const std::string linear = number(row.linear());
  const std::string angular = number(row.angular(0.3));
  return number(row.t_s) + "," + (angular_first ? angular + "," + linear : linear + "," + angular) + "," +
         std::to_string(left ? -row.counts_left : row.counts_left) + "," +
         std::to_string(left ? row.counts_right : -row.counts_right);
}

}  // namespace

TEST_CASE("Whole numbers that lead to as many millimetres per second are mm/s, not a duty") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "", commands_in_millimetres),
                                   {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  check_same(outcome, drive);
  CHECK(outcome.found("commands are in mm/s"));
}

TEST_CASE("Whole numbers that lead to something else stay a duty") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "", commands_in_millimetres),
                                   {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.001"});
  CHECK(outcome.found("a duty"));
  CHECK(!outcome.found("commands are in mm/s"));
}

TEST_CASE("Where nothing tells the scale, the refusal says how commands in mm/s are stated") {
  const ForeignDrive drive = foreign_drive();
  const std::string text = foreign_text(drive, "", commands_in_millimetres);
  const auto refused = import_text(text, {"robot.wheel_base_m=0.3"});
  REQUIRE(!refused.conversion);
  CHECK_THAT(refused.conversion.error(), ContainsSubstring("--set command.unit=mm/s"));
  check_same(import_text(text, {"robot.wheel_base_m=0.3", "command.unit=mm/s"}), drive);
}

TEST_CASE("A wheel that counts backwards does not exchange forward and turning speed") {
  const ForeignDrive drive = foreign_drive();
  const bool left = GENERATE(true, false);
  const bool angular_first = GENERATE(true, false);
  const bool base_is_known_before = GENERATE(true, false);
  CAPTURE(left, angular_first, base_is_known_before);
  std::vector<std::string> settings{"robot.wheel_base_m=0.3"};
  if (!base_is_known_before) settings.clear();
  const auto outcome = import_text(foreign_text(drive, "",
                                                [&](const ForeignRow& row) {
                                                  return twist_with_reversed_wheel(row, left, angular_first);
                                                }),
                                   settings);
  CHECK(outcome.found(left ? "the left wheel counts backwards" : "the right wheel counts backwards"));
  CHECK(outcome.understood.mapping.command->first.channel == (angular_first ? "3" : "2"));
  if (base_is_known_before) check_same(outcome, drive);
}

TEST_CASE("The scale by forward commands takes a stated reversed wheel as it is") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(
      foreign_text(drive, "t,v,w,left_ticks,right_ticks",
                   [](const ForeignRow& row) { return twist_with_reversed_wheel(row, false, false); }),
      {"robot.wheel_base_m=0.3", "wheels.reversed=right"});
  check_same(outcome, drive);
}

TEST_CASE("A counter that never moves beside a second command is said") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "",
                                                [](const ForeignRow& row) {
                                                  return number(row.t_s) + "," + number(row.command_left) +
                                                         "," + number(row.command_right) + "," +
                                                         std::to_string(row.counts_left) + ",0";
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  CHECK(outcome.found("column 5 never moves, and column 3 goes as a command does"));
}

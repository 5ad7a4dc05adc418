// Motors that are called by letters, by rows of their own, or by the inputs of their driver.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> motor_settings{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005",
                                              "command.full_scale=100", "command.full_scale_m_s=0.5"};

std::string percent(double command_m_s) {
  return field(200.0 * command_m_s);
}

}  // namespace

TEST_CASE("Motors A and B are the left and the right wheel, and that nothing says so is said") {
  const ForeignDrive drive = foreign_drive();
  for (const char* names :
       {"pwmA,pwmB,encA,encB", "Motor_A,Motor_B,Encoder_A,Encoder_B", "pwm_a,pwm_b,enc_a,enc_b"}) {
    CAPTURE(names);
    const auto outcome = import_text(foreign_text(drive, std::string("t,") + names,
                                                  [](const ForeignRow& row) {
                                                    return number(row.t_s) + percent(row.command_left) +
                                                           percent(row.command_right) + "," + counts(row);
                                                  }),
                                     motor_settings);
    check_same(outcome, drive);
    CHECK(outcome.found("nothing says so"));
  }
}

TEST_CASE("Rows that hold one side each are two wheels") {
  const ForeignDrive drive = foreign_drive();
  std::string text = "t,motor,target,count\n";
  for (const auto& row : drive.rows) {
    text +=
        number(row.t_s) + ",left" + field(row.command_left) + "," + std::to_string(row.counts_left) + "\n";
    text +=
        number(row.t_s) + ",right" + field(row.command_right) + "," + std::to_string(row.counts_right) + "\n";
  }
  check_same(import_text(text, seen_settings), drive);
}

TEST_CASE("Four inputs of a motor driver are two commands, forward less backward, by size or beside it") {
  const ForeignDrive drive = foreign_drive();
  const auto side = [](double command, bool is_bit) {
    const double size = is_bit ? 1.0 : 200.0 * std::abs(command);
    return field(command > 0.0 ? size : 0.0) + field(command < 0.0 ? size : 0.0);
  };
  for (const bool is_bit : {false, true}) {
    CAPTURE(is_bit);
    const auto outcome = import_text(
        foreign_text(drive, std::string("t,IN1,IN2,IN3,IN4,encL,encR") + (is_bit ? ",ENA,ENB" : ""),
                     [&](const ForeignRow& row) {
                       return number(row.t_s) + side(row.command_left, is_bit) +
                              side(row.command_right, is_bit) + "," + counts(row) +
                              (is_bit ? percent(std::abs(row.command_left)) +
                                            percent(std::abs(row.command_right))
                                      : std::string());
                     }),
        motor_settings);
    check_same(outcome, drive);
  }
}

TEST_CASE("One wheel that is found by its motion beside columns of another is doubted") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "time,a,b,c,d",
                                                [](const ForeignRow& row) {
                                                  return number(row.t_s) + field(row.command_left) + "," +
                                                         std::to_string(row.counts_left) +
                                                         field(std::sin(9.0 * row.t_s)) +
                                                         field(std::cos(7.0 * row.t_s));
                                                }),
                                   {});
  CHECK(outcome.doubts("one wheel alone is read"));
}

TEST_CASE("Of motors that no name tells apart the reference shows which is the left one") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(
      foreign_text(drive, "t,pwmA,pwmB,encA,encB,x,y,theta",
                   [](const ForeignRow& row) {
                     return number(row.t_s) + percent(row.command_right) + percent(row.command_left) + "," +
                            std::to_string(row.counts_right) + "," + std::to_string(row.counts_left) +
                            field(row.x) + field(row.y) + field(row.theta);
                   }),
      motor_settings);
  check_same(outcome, drive);
  CHECK(outcome.found("the right wheel stands first"));
}

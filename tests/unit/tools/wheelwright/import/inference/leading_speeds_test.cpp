// Speeds that were asked for, and speeds that were measured.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

std::string twist_of(const ForeignRow& row) {
  return field(row.linear()) + field(row.angular(ForeignDrive::base_m));
}

// Each speed stands in the five rows after it was measured over 0.25 s.
ImportOutcome import_measured(const ForeignDrive& drive, const std::string& names) {
  std::string text = "t," + names + ",encL,encR\n";
  double v = 0.0, w = 0.0;
  for (std::size_t k = 0; k < drive.rows.size(); ++k) {
    if (k % 5 == 0 && k > 0) {
      const auto metres = [&](std::int64_t now, std::int64_t before) {
        return ForeignDrive::metres_per_count * static_cast<double>(now - before);
      };
      const double left = metres(drive.rows[k].counts_left, drive.rows[k - 5].counts_left) / 0.25;
      const double right = metres(drive.rows[k].counts_right, drive.rows[k - 5].counts_right) / 0.25;
      v = 0.5 * (left + right);
      w = (right - left) / ForeignDrive::base_m;
    }
    text += number(drive.rows[k].t_s) + field(v) + field(w) + "," + counts(drive.rows[k]) + "\n";
  }
  return import_text(text, seen_settings);
}

}  // namespace

TEST_CASE("What a controller makes of a speed is no command beside it, whatever the speed is called") {
  const ForeignDrive drive = foreign_drive();
  for (const char* names : {"cmd_v,cmd_w", "linear_x,angular_z"}) {
    CAPTURE(names);
    const auto outcome = import_text(
        foreign_text(drive, std::string("t,") + names + ",left_pwm,right_pwm,encL,encR",
                     [](const ForeignRow& row) {
                       return number(row.t_s) + twist_of(row) + field(std::round(310.0 * row.command_left)) +
                              field(std::round(290.0 * row.command_right)) + "," + counts(row);
                     }),
        seen_settings);
    check_same(outcome, drive);
    CHECK(outcome.understood.mapping.command->kind == import::CommandKind::twist);
  }
}

TEST_CASE("Speeds that change at every row are commands if the wheels come behind them") {
  const ForeignDrive drive = joystick_drive();
  const auto outcome = import_text(
      foreign_text(drive, "t,v,w,encL,encR",
                   [](const ForeignRow& row) { return number(row.t_s) + twist_of(row) + "," + counts(row); }),
      seen_settings);
  check_same(outcome, drive);
  CHECK(outcome.found("the wheels follow them"));
}

TEST_CASE("Measured speeds that are repeated in faster rows are no commands") {
  for (const char* names : {"v,w", "odom_v,odom_w"}) {
    CAPTURE(names);
    const auto outcome = import_measured(foreign_drive(), names);
    CHECK_FALSE(outcome.understood.mapping.command);
  }
}

TEST_CASE("The forward speed of a body alone, and speeds along the floor, are no wheel") {
  const ForeignDrive drive = foreign_drive();
  double last_x = 0.0, last_y = 0.0;
  const auto outcome = import_text(foreign_text(drive, "t,cmd_v,cmd_w,x,y,theta,vx,vy",
                                                [&](const ForeignRow& row) {
                                                  const double vx = (row.x - last_x) / 0.05;
                                                  const double vy = (row.y - last_y) / 0.05;
                                                  last_x = row.x;
                                                  last_y = row.y;
                                                  return number(row.t_s) + twist_of(row) + field(row.x) +
                                                         field(row.y) + field(row.theta) + field(vx) +
                                                         field(vy);
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  CHECK_FALSE(outcome.understood.mapping.wheels);
  check_seen(outcome, drive);
  const auto forward = import_text(foreign_text(drive, "t,cmd_v,cmd_w,x,y,theta,speed",
                                                [&](const ForeignRow& row) {
                                                  return number(row.t_s) + twist_of(row) + field(row.x) +
                                                         field(row.y) + field(row.theta) +
                                                         field(std::abs(row.linear()));
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  CHECK_FALSE(forward.understood.mapping.wheels);
}

TEST_CASE("A wheel base is suggested from turns in degrees as from turns in radians") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,cmd_v_m_s,cmd_w_deg_s,encL,encR",
                               [](const ForeignRow& row) {
                                 return number(row.t_s) + field(row.linear()) +
                                        field(180.0 / std::numbers::pi * row.angular(ForeignDrive::base_m)) +
                                        "," + counts(row);
                               }),
                  {"wheels.metres_per_count=0.0005"});
  CHECK(outcome.found("wheel base of about 0.3"));
}

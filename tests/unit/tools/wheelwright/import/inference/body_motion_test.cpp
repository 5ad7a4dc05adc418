// Robots that say how their body moved, not their wheels.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
const std::string body_base = "robot.wheel_base_m=0.3";

double forward_m(const ForeignRow& row) {
  return 0.5 * ForeignDrive::metres_per_count * static_cast<double>(row.counts_left + row.counts_right);
}

double turned_rad(const ForeignRow& row) {
  return ForeignDrive::metres_per_count * static_cast<double>(row.counts_right - row.counts_left) /
         ForeignDrive::base_m;
}

std::string wheel_commands_of(const ForeignRow& row) {
  return number(row.t_s) + field(1e3 * row.command_left) + field(1e3 * row.command_right);
}

}  // namespace

TEST_CASE("How far a robot went and turned in all, in millimetres and degrees, is what its wheels did") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,cmd_left_mm_s,cmd_right_mm_s,total_distance_mm,total_angle_deg",
                               [](const ForeignRow& row) {
                                 return wheel_commands_of(row) + field(std::round(1e3 * forward_m(row))) +
                                        field(std::round(degrees * turned_rad(row)));
                               }),
                  {body_base});
  check_same(outcome, drive);
  CHECK(outcome.understood.mapping.wheels->body_motion);
  CHECK(outcome.understood.mapping.wheels->angular_unit == "deg");
}

TEST_CASE("A distance and an angle since the row before are summed, as a Create gives them") {
  const ForeignDrive drive = foreign_drive();
  for (const char* names : {"cmd_left_mm_s,cmd_right_mm_s", "cmd_left,cmd_right"}) {
    CAPTURE(names);
    double last_mm = 0.0;
    double last_deg = 0.0;
    const auto outcome =
        import_text(foreign_text(drive, std::string("t,") + names + ",distance,angle",
                                 [&](const ForeignRow& row) {
                                   // Parts of a millimetre or degree are left for the next packet.
                                   const double mm = std::round(1e3 * forward_m(row) - last_mm);
                                   const double deg = std::round(degrees * turned_rad(row) - last_deg);
                                   last_mm += mm;
                                   last_deg += deg;
                                   return wheel_commands_of(row) + field(mm) + field(deg);
                                 }),
                    {body_base});
    check_same(outcome, drive);
    CHECK(outcome.understood.mapping.wheels->per_row);
  }
}

TEST_CASE("A turning speed without a unit is in degrees where the robot then turns as commanded") {
  const ForeignDrive drive = foreign_drive();
  const auto measured = [&](double unit, bool as_twist) {
    double last_m = 0.0;
    double last_rad = 0.0;
    return import_text(
        foreign_text(drive,
                     std::string(as_twist ? "t,cmd_v,cmd_w" : "t,cmd_left,cmd_right") + ",odom_v,odom_w",
                     [&](const ForeignRow& row) {
                       const double v = (forward_m(row) - last_m) / drive.period_s;
                       const double w = (turned_rad(row) - last_rad) / drive.period_s;
                       last_m = forward_m(row);
                       last_rad = turned_rad(row);
                       return number(row.t_s) + field(as_twist ? row.linear() : row.command_left) +
                              field(as_twist ? row.angular(ForeignDrive::base_m) : row.command_right) +
                              field(v) + field(unit * w);
                     }),
        {body_base});
  };
  for (const bool as_twist : {true, false}) {
    CAPTURE(as_twist);
    const auto in_degrees = measured(degrees, as_twist);
    check_same(in_degrees, drive);
    CHECK(in_degrees.understood.mapping.wheels->angular_unit == "deg/s");
    const auto in_radians = measured(1.0, as_twist);
    check_same(in_radians, drive);
    CHECK(in_radians.understood.mapping.wheels->angular_unit.empty());
  }
}

TEST_CASE("The unit of a turning motion can be stated") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,cmd_left,cmd_right,a,b",
                               [](const ForeignRow& row) {
                                 return number(row.t_s) + field(row.command_left) + field(row.command_right) +
                                        field(100.0 * forward_m(row)) + field(1e3 * turned_rad(row));
                               }),
                  {body_base, "wheels.kind=distance", "wheels.linear=a", "wheels.angular=b", "wheels.unit=cm",
                   "wheels.angular_unit=mrad"});
  check_same(outcome, drive);
}

TEST_CASE("The distance to a wall and the angle of what looks at it are no motion of the body") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "t,cmd_v,cmd_w,sonar_distance_cm,servo_angle",
                                                [](const ForeignRow& row) {
                                                  return number(row.t_s) + field(row.linear()) +
                                                         field(row.angular(ForeignDrive::base_m)) +
                                                         field(std::round(80.0 + 40.0 * std::sin(row.t_s))) +
                                                         field(std::round(90.0 + 80.0 * std::cos(row.t_s)));
                                                }),
                                   {body_base});
  CHECK_FALSE(outcome.understood.mapping.wheels);
}

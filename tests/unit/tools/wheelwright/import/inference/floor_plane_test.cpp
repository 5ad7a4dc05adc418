// Trackers whose y points up: the robot moves in x and z.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

using std::numbers::pi;

constexpr double height = 0.12;

// A height that a tracker measures, of a robot on a floor.
double height_of(const ForeignRow& row) {
  return height + 2e-4 * std::sin(40.0 * row.t_s);
}

double degrees_of_turn(double angle_rad) {
  const double degrees = std::fmod(angle_rad * 180.0 / pi, 360.0);
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

std::string joined(std::initializer_list<double> values) {
  std::string line;
  for (const double value : values) {
    line += ',';
    line += number(value);
  }
  return line;
}

// Of a turn about y.
std::string quaternion(double turn_rad) {
  return joined({0.0, std::sin(0.5 * turn_rad), 0.0, std::cos(0.5 * turn_rad)});
}

}  // namespace

TEST_CASE("A right-handed tracker whose y points up sees the robot in x and z") {
  const auto drive = foreign_drive();
  const auto outcome = import_seen(drive, "x,y,z,qx,qy,qz,qw", [](const ForeignRow& row) {
    return joined({row.x, height_of(row), -row.y}) + quaternion(row.theta);
  });
  check_seen(outcome, drive);
  CHECK(outcome.found("y points up"));
}

TEST_CASE("A left-handed tracker whose y points up is mirrored back, by quaternion and by angles") {
  const auto drive = foreign_drive();
  const auto by_quaternion =
      import_seen(drive, "pos_x,pos_y,pos_z,rot_x,rot_y,rot_z,rot_w", [](const ForeignRow& row) {
        return joined({-row.y, height_of(row), row.x}) + quaternion(-row.theta);
      });
  check_seen(by_quaternion, drive);
  CHECK(by_quaternion.found("the reference is mirrored"));
  const auto by_angles =
      import_seen(drive, "position.x,position.y,position.z,eulerAngles.x,eulerAngles.y,eulerAngles.z",
                  [](const ForeignRow& row) {
                    return joined({-row.y, height_of(row), row.x, 359.9, degrees_of_turn(-row.theta), 0.1});
                  });
  check_seen(by_angles, drive);
}

TEST_CASE("Euler angles that turn the robot on its back at a quarter turn are unfolded") {
  const auto drive = foreign_drive();
  const auto outcome = import_seen(drive, "x,y,z,rx,ry,rz", [](const ForeignRow& row) {
    const double turn = std::remainder(row.theta, 2.0 * pi);
    const bool is_folded = std::abs(turn) > 0.5 * pi;
    const double flip = is_folded ? 180.0 : 0.0;
    const double heading = is_folded ? std::copysign(pi, turn) - turn : turn;
    return joined({row.x, height_of(row), -row.y, flip, heading * 180.0 / pi, flip});
  });
  check_seen(outcome, drive);
  CHECK(outcome.understood.mapping.reference->roll->channel == "rx");
}

TEST_CASE("A ramp does not make y point up") {
  const auto drive = foreign_drive();
  const auto outcome = import_seen(drive, "x,y,z,yaw", [](const ForeignRow& row) {
    return joined({row.x, row.y, 0.1 * row.x, row.theta});
  });
  check_seen(outcome, drive);
}

TEST_CASE("Headings in degrees of a reference in a file of its own are recognised across their wraps") {
  const auto drive = foreign_drive();
  const std::string robot =
      foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right", [](const ForeignRow& row) {
        return number(row.t_s) + field(row.command_left) + field(row.command_right) + "," + counts(row);
      });
  const std::string tracker = foreign_text(drive, "t,x,y,yaw", [](const ForeignRow& row) {
    return number(row.t_s + 3.0) + joined({row.x, row.y, degrees_of_turn(row.theta)});
  });
  const auto understood = import::understand({{file_of("robot.csv", robot)},
                                              file_of("tracker.csv", tracker),
                                              import::GivenMapping("", seen_settings)});
  REQUIRE(understood);
  CHECK(understood->mapping.reference->angle_unit == "deg");
}

TEST_CASE("The unit that a motion capture system states for its lengths is that of the places") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(
      "# Length Units: Centimeters\n" +
          foreign_text(drive, "t,cmd_left,cmd_right,n_left,n_right,x,y,yaw",
                       [](const ForeignRow& row) {
                         return number(row.t_s) + field(row.command_left) + "," + number(row.command_right) +
                                "," + counts(row) + joined({100.0 * row.x, 100.0 * row.y, row.theta});
                       }),
      seen_settings);
  check_seen(outcome, drive);
  CHECK_FALSE(outcome.found("places are in"));
}

TEST_CASE("The frame of a reference with a clock of its own is seen once the clock is shifted") {
  const auto drive = foreign_drive();
  const std::string robot =
      foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right", [](const ForeignRow& row) {
        return number(row.t_s) + field(row.command_left) + field(row.command_right) + "," + counts(row);
      });
  // A camera: x to the right, y down, z ahead.
  std::string trajectory;
  for (const ForeignRow& row : drive.rows) {
    trajectory += number(row.t_s + 30.0);
    for (const double value :
         {-row.y, height_of(row), row.x, 0.0, std::sin(-0.5 * row.theta), 0.0, std::cos(-0.5 * row.theta)})
      trajectory.append(" ").append(number(value));
    trajectory += "\n";
  }
  auto understood = import::understand({{file_of("robot.csv", robot)},
                                        file_of("camera.tum", trajectory),
                                        import::GivenMapping("", seen_settings)});
  REQUIRE(understood);
  CHECK(has_words(understood->inference.findings, "the reference is mirrored"));
  CHECK(understood->mapping.reference->clockwise);
  CHECK(understood->mapping.reference->y_points_right);
}

// Units that stand in the names of columns.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

constexpr double radius_m = 0.04;
constexpr double turn_m = 2.0 * std::numbers::pi * radius_m;
constexpr double inch_in_m = 0.0254;

ImportOutcome import_travel(const ForeignDrive& drive, const std::string& names, double metres_of_one,
                            std::vector<std::string> settings) {
  settings.emplace_back("robot.wheel_base_m=0.3");
  return import_text(foreign_text(drive, "t,cmd_left,cmd_right," + names,
                                  [&](const ForeignRow& row) {
                                    const auto travel = [&](std::int64_t count) {
                                      return field(ForeignDrive::metres_per_count *
                                                   static_cast<double>(count) / metres_of_one);
                                    };
                                    return number(row.t_s) + field(row.command_left) +
                                           field(row.command_right) + travel(row.counts_left) +
                                           travel(row.counts_right);
                                  }),
                     settings);
}

}  // namespace

TEST_CASE("Turns of a wheel are turns by any of their names, and inches are inches") {
  const ForeignDrive drive = foreign_drive();
  for (const char* names :
       {"leftPositionRotations,rightPositionRotations", "left_pos_rev,right_pos_rev", "left_revs,right_revs",
        "left_turns,right_turns", "axis0.encoder.pos_estimate,axis1.encoder.pos_estimate"}) {
    CAPTURE(names);
    check_same(import_travel(drive, names, turn_m, {"wheels.wheel_radius_m=0.04"}), drive);
  }
  check_same(import_travel(drive, "left_pos_in,right_pos_in", inch_in_m, {}), drive);
}

TEST_CASE("A wheel radius that no unit asks for is doubted") {
  const ForeignDrive drive = foreign_drive();
  const auto in_metres = import_travel(drive, "left_pos_m,right_pos_m", 1.0, {"wheels.wheel_radius_m=0.04"});
  CHECK(in_metres.doubts("wheels.wheel_radius_m changes nothing"));
  const auto counted =
      import_travel(drive, "encL,encR", ForeignDrive::metres_per_count, {"wheels.wheel_radius_m=0.04"});
  CHECK(counted.doubts("wheels.counts_per_turn"));
}

TEST_CASE("Headings in tenths and hundredths of a degree are read by name, by wraps and by the wheels") {
  const ForeignDrive drive = foreign_drive();
  constexpr double degrees = 180.0 / std::numbers::pi;
  for (const auto& [name, per_degree, wraps] : {std::tuple{"yaw_x10", 10.0, false},
                                                {"yaw_x100", 100.0, false},
                                                {"yaw", 10.0, true},
                                                {"yaw", 10.0, false}}) {
    CAPTURE(name, per_degree, wraps);
    const auto outcome = import_seen(
        drive, std::string("x,y,") + name, [&, per = per_degree, wrap = wraps](const ForeignRow& row) {
          const double heading = wrap ? std::remainder(row.theta, 2.0 * std::numbers::pi) : row.theta;
          return field(row.x) + field(row.y) + field(std::round(per * degrees * heading));
        });
    check_seen(outcome, drive);
  }
}

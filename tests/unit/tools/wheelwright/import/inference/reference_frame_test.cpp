// References in frames of their own: clockwise headings, a y axis that points right, a heading that is turned
// on the robot.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

using std::numbers::pi;

const std::vector<std::string> frame_settings{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

struct TrackerPose {
  double x, y, heading;
};

ImportOutcome import_seen_as(
    const ForeignDrive& drive, const std::function<TrackerPose(const ForeignRow&)>& seen,
    const std::string& header = "t,cmd_left,cmd_right,enc_left,enc_right,mocap_x,mocap_y,mocap_yaw",
    const std::vector<std::string>& settings = frame_settings) {
  return import_text(foreign_text(drive, header,
                                  [&](const ForeignRow& row) {
                                    const TrackerPose pose = seen(row);
                                    std::string line = number(row.t_s) + "," + number(row.command_left) +
                                                       "," + number(row.command_right) + "," + counts(row);
                                    for (const double value : {pose.x, pose.y, pose.heading}) {
                                      line += ",";
                                      line += number(value);
                                    }
                                    return line;
                                  }),
                     settings);
}

// Places and headings are those of the drive, but for a turn of the whole floor.
void check_frame(const ImportOutcome& outcome, const ForeignDrive& drive, double floor_turn_rad = 0.0) {
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  const DriveLog& log = outcome.conversion->runs.front();
  REQUIRE(log.samples.size() == drive.rows.size());
  const double c = std::cos(floor_turn_rad);
  const double s = std::sin(floor_turn_rad);
  double worst_m = 0.0;
  double worst_rad = 0.0;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const ForeignRow& row = drive.rows[k];
    worst_m = std::max(worst_m, std::hypot(*log.samples[k].reference_x_m - (c * row.x - s * row.y),
                                           *log.samples[k].reference_y_m - (s * row.x + c * row.y)));
    worst_rad = std::max(
        worst_rad, std::abs(wrap_angle(*log.samples[k].reference_theta_rad - row.theta - floor_turn_rad)));
  }
  CHECK(worst_m < 1e-4);
  CHECK(worst_rad < 0.003);
}

double in_degrees_of_a_turn(double heading_rad) {
  const double degrees = std::fmod(heading_rad * 180.0 / pi, 360.0);
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

}  // namespace

TEST_CASE("Clockwise headings are turned round, in radians and degrees, with names and without") {
  const auto drive = foreign_drive();
  for (const char* header : {"t,cmd_left,cmd_right,enc_left,enc_right,mocap_x,mocap_y,mocap_yaw", ""}) {
    INFO(header);
    for (const double unit : {1.0, 180.0 / pi}) {
      const auto outcome = import_seen_as(
          drive,
          [unit](const ForeignRow& row) {
            return TrackerPose{row.x, row.y, -unit * row.theta};
          },
          header);
      check_frame(outcome, drive);
      CHECK(outcome.found("headings are clockwise"));
    }
  }
}

TEST_CASE("The heading of a compass, clockwise from y, is turned round and back") {
  const auto drive = foreign_drive();
  const auto outcome = import_seen_as(drive, [](const ForeignRow& row) {
    return TrackerPose{row.x, row.y, in_degrees_of_a_turn(0.5 * pi - row.theta)};
  });
  check_frame(outcome, drive);
  CHECK(outcome.found("headings are in degrees"));
}

TEST_CASE("A y axis that points right is turned round, and so are x and y that are exchanged") {
  const auto drive = foreign_drive();
  const auto right = import_seen_as(drive, [](const ForeignRow& row) {
    return TrackerPose{row.x, -row.y, row.theta};
  });
  check_frame(right, drive);
  CHECK(right.found("the places are mirrored, so that y points right"));
  const auto exchanged = import_seen_as(drive, [](const ForeignRow& row) {
    return TrackerPose{row.y, row.x, row.theta};
  });
  check_frame(exchanged, drive, -0.5 * pi);
}

TEST_CASE("A frame whose z points down is doubted, and read as such where that is stated") {
  const auto drive = foreign_drive();
  const auto seen = [](const ForeignRow& row) { return TrackerPose{row.x, -row.y, -row.theta}; };
  CHECK(import_seen_as(drive, seen).doubts("in a frame whose z points down"));
  auto settings = frame_settings;
  settings.emplace_back("reference.heading=clockwise");
  settings.emplace_back("reference.y_axis=right");
  const auto stated = import_seen_as(
      drive, seen, "t,cmd_left,cmd_right,enc_left,enc_right,mocap_x,mocap_y,mocap_yaw", settings);
  check_frame(stated, drive);
  CHECK_FALSE(stated.doubts("in a frame"));
}

TEST_CASE("A heading that is turned on the robot is turned back, unless the offset is stated") {
  const auto drive = foreign_drive();
  const auto seen = [](const ForeignRow& row) { return TrackerPose{row.x, row.y, row.theta + 0.1}; };
  const auto outcome = import_seen_as(drive, seen);
  check_frame(outcome, drive);
  CHECK(outcome.remarks("the heading of the reference is turned by 5."));
  auto settings = frame_settings;
  settings.emplace_back("reference.heading_offset_deg=0");
  const auto stated = import_seen_as(
      drive, seen, "t,cmd_left,cmd_right,enc_left,enc_right,mocap_x,mocap_y,mocap_yaw", settings);
  REQUIRE(stated.conversion);
  CHECK_THAT(*stated.conversion->runs.front().samples.front().reference_theta_rad, WithinAbs(0.1, 1e-6));
}

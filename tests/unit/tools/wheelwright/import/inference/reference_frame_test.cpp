// References in frames of their own: clockwise headings, a y axis that points right, a heading that is turned
// on the robot.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

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
                                                       field(row.command_right) + "," + counts(row);
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

TEST_CASE(
    "A frame whose z points down is turned round where an angular command or a gyro agrees with the wheels") {
  const auto drive = foreign_drive();
  const auto below = [](const ForeignRow& row) {
    std::string line;
    for (const double value : {row.x, -row.y, -row.theta}) {
      line += ",";
      line += number(value);
    }
    return line;
  };
  const auto twist = import_text(foreign_text(drive, "t,v_cmd,w_cmd,enc_left,enc_right,x,y,yaw",
                                              [&](const ForeignRow& row) {
                                                return number(row.t_s) + "," + number(row.linear()) + "," +
                                                       number(row.angular(ForeignDrive::base_m)) + "," +
                                                       counts(row) + below(row);
                                              }),
                                 frame_settings);
  check_frame(twist, drive);
  CHECK(twist.found("the reference is mirrored, as in a frame whose z points down"));
  double last = 0.0;
  const auto gyro = import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right,gyro_z,x,y,yaw",
                                             [&](const ForeignRow& row) {
                                               const double rate = (row.theta - last) / drive.period_s;
                                               last = row.theta;
                                               return number(row.t_s) + "," + number(row.command_left) + "," +
                                                      number(row.command_right) + "," + counts(row) + "," +
                                                      number(rate) + below(row);
                                             }),
                                frame_settings);
  check_frame(gyro, drive);
}

TEST_CASE("Where wheels turn against their angular command it is not the reference that is turned round") {
  const auto outcome = import_text(
      foreign_text(foreign_drive(), "t,v_cmd,w_cmd,enc_left,enc_right,x,y,yaw",
                   [](const ForeignRow& row) {
                     return number(row.t_s) + "," + number(row.linear()) + "," +
                            number(row.angular(ForeignDrive::base_m)) + "," +
                            std::to_string(row.counts_right) + "," + std::to_string(row.counts_left) + "," +
                            number(row.x) + "," + number(row.y) + "," + number(row.theta);
                   }),
      frame_settings);
  CHECK_FALSE(outcome.understood.mapping.reference->y_points_right);
  CHECK(outcome.doubts("and so does the angular command: the left and the right wheel are exchanged"));
}

TEST_CASE("Places to the north and east are in a known frame, with headings from north and without") {
  const auto drive = foreign_drive();
  for (const char* names : {"north,east,heading", "pos_n,pos_e,psi", "northing,easting"}) {
    INFO(names);
    const bool has_heading = !std::string(names).starts_with("northing");
    const auto outcome = import_text(
        foreign_text(drive, std::string("t,cmd_left,cmd_right,enc_left,enc_right,") + names,
                     [&](const ForeignRow& row) {
                       return number(row.t_s) + "," + number(row.command_left) + "," +
                              number(row.command_right) + "," + counts(row) + "," + number(row.x) + "," +
                              number(-row.y) + (has_heading ? field(-row.theta) : "");
                     }),
        frame_settings);
    REQUIRE(outcome.conversion);
    CHECK(outcome.understood.mapping.reference->y_points_right);
    CHECK(outcome.understood.inference.doubts.empty());
    CHECK_THAT(*outcome.conversion->runs.front().samples.back().reference_y_m,
               WithinAbs(drive.rows.back().y, 1e-4));
    if (has_heading) check_frame(outcome, drive);
  }
}

TEST_CASE("Places without headings that turn against the wheels or the commands are doubted") {
  const auto drive = foreign_drive();
  for (const char* names : {"t,cmd_left,cmd_right,enc_left,enc_right,x,y", "t,cmd_left,cmd_right,x,y"}) {
    INFO(names);
    const bool has_counts = std::string(names).find("enc") != std::string::npos;
    const auto outcome = import_text(foreign_text(drive, names,
                                                  [&](const ForeignRow& row) {
                                                    return number(row.t_s) + "," + number(row.command_left) +
                                                           field(row.command_right) + "," +
                                                           (has_counts ? counts(row) + "," : "") +
                                                           number(row.x) + "," + number(-row.y);
                                                  }),
                                     frame_settings);
    CHECK(outcome.doubts("y points right of x"));
  }
}

TEST_CASE("Headings against the wheels beside places that are too noisy to say are not left in silence") {
  const auto drive = foreign_drive();
  const auto noisy = [](const ForeignRow& row, double phase) {
    return field(row.x + std::sin(9871.0 * row.t_s + phase)) +
           field(row.y + std::sin(7919.0 * row.t_s + 2.0 * phase));
  };
  const auto outcome = import_seen(
      drive, "x,y,yaw", [&](const ForeignRow& row) { return noisy(row, 0.3) + field(-row.theta); });
  CHECK(outcome.doubts("headings turn against the wheels"));
  const auto on_a_map = import_seen(drive, "north,east,heading", [&](const ForeignRow& row) {
    return noisy(row, 0.7) + field(-row.theta);
  });
  CHECK(on_a_map.understood.mapping.reference->clockwise);
}

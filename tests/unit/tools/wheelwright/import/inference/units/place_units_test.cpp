// References whose places are in no unit of length: on the globe, and in an image.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"
#include "tools/wheelwright/import/conversion/local_metres.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

using std::numbers::pi;

// East and north in metres as degrees about a place at 47.3 degrees north, by series of the ellipsoid.
std::string on_the_globe(double east_m, double north_m) {
  constexpr double latitude = 47.3;
  constexpr double phi = latitude * pi / 180.0;
  const double of_latitude_m = 111132.954 - 559.822 * std::cos(2.0 * phi) + 1.175 * std::cos(4.0 * phi);
  const double of_longitude_m = 111412.84 * std::cos(phi) - 93.5 * std::cos(3.0 * phi);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ",%.9f,%.9f", latitude + north_m / of_latitude_m,
                8.5 + east_m / of_longitude_m);
  return text.data();
}

std::string compass(double theta) {
  const double degrees = std::fmod(90.0 - theta * 180.0 / pi, 360.0);
  return field(degrees < 0.0 ? degrees + 360.0 : degrees);
}

std::string in_image(const ForeignRow& row) {
  return field(640.0 + 310.0 * row.x) + field(480.0 - 310.0 * row.y);
}

}  // namespace

TEST_CASE("Latitude and longitude are places in metres, with the heading of a compass and without") {
  const auto drive = foreign_drive();
  const auto with_heading = import_seen(drive, "latitude,longitude,heading_deg", [](const ForeignRow& row) {
    return on_the_globe(row.x, row.y) + compass(row.theta);
  });
  check_seen(with_heading, drive, 0.002);
  CHECK(with_heading.understood.mapping.reference->unit == "deg");
  CHECK(with_heading.found("headings are clockwise"));
  CHECK_FALSE(with_heading.remarks("the heading of the reference is turned"));
  const auto alone =
      import_seen(drive, "gps_lat,gps_lon", [](const ForeignRow& row) { return on_the_globe(row.x, row.y); });
  check_seen(alone, drive, 0.002);
  CHECK_FALSE(alone.conversion->runs.front().samples.front().reference_theta_rad);
}

TEST_CASE("Rows without a fix hold no place, and numbers beyond the globe are no degrees") {
  const auto drive = foreign_drive();
  const auto without_fix = import_seen(drive, "lat,lon", [](const ForeignRow& row) {
    return row.t_s < 2.0 ? std::string(",0,0") : on_the_globe(row.x, row.y);
  });
  check_seen(without_fix, drive, 0.002);
  CHECK_FALSE(without_fix.conversion->runs.front().samples[10].reference_x_m);
  const auto minutes = import_seen(
      drive, "lat,lon", [](const ForeignRow& row) { return field(4718.0 + row.x) + field(830.0 + row.y); });
  CHECK_FALSE(minutes.understood.mapping.reference);
  CHECK(minutes.found("are not in degrees"));
}

TEST_CASE("Metres about a fix are those of the ellipsoid") {
  const std::vector<double> longitude{8.5, 8.501};
  const std::vector<double> latitude{47.3, 47.301};
  const auto metres = import::local_metres(longitude, latitude);
  CHECK_THAT(metres.east[1], WithinAbs(75.62, 0.02));
  CHECK_THAT(metres.north[1], WithinAbs(111.18, 0.02));
}

TEST_CASE("The wheels show how far a pixel is on the floor, with a heading and without") {
  const auto drive = foreign_drive();
  for (const char* names : {"x_px,y_px,theta", "x_px,y_px", "cx [px],cy [pixels]"}) {
    INFO(names);
    const bool has_heading = std::string(names).ends_with("theta");
    const auto outcome = import_seen(drive, names, [&](const ForeignRow& row) {
      return in_image(row) + (has_heading ? field(row.theta) : "");
    });
    check_seen(outcome, drive, 0.02);
    CHECK_THAT(*outcome.understood.mapping.reference->metres_per_pixel, WithinRel(1.0 / 310.0, 0.003));
    CHECK(outcome.understood.mapping.reference->scale_from_robot);
    CHECK(outcome.found("a pixel is"));
  }
}

TEST_CASE("Places that go hundreds of times as far as the wheels are taken for pixels, with a doubt") {
  const auto drive = foreign_drive();
  const auto outcome =
      import_seen(drive, "x,y,theta", [](const ForeignRow& row) { return in_image(row) + field(row.theta); });
  check_seen(outcome, drive, 0.02);
  CHECK(outcome.doubts("x and y are in no unit of length"));
}

TEST_CASE("Without wheels the commands show that places are in mm and headings in degrees") {
  const auto drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,cmd_left,cmd_right,x,y,theta",
                               [](const ForeignRow& row) {
                                 return number(row.t_s) + "," + number(row.command_left) + "," +
                                        number(row.command_right) + field(1000.0 * row.x - 5000.0) +
                                        field(1000.0 * row.y) + field(180.0 / pi * row.theta);
                               }),
                  {"robot.wheel_base_m=" + number(ForeignDrive::base_m)});
  REQUIRE(outcome.conversion);
  CHECK(outcome.understood.mapping.reference->unit == "mm");
  CHECK(outcome.understood.mapping.reference->angle_unit == "deg");
  CHECK(outcome.found("headings are in degrees"));
}

TEST_CASE("Rows as close as a simulator's own steps do not contradict the period of its commands") {
  std::string text = "t,cmd_left,cmd_right,x,y,theta\n";
  for (int row = 0; row < 4000; ++row) {
    const double t_s = 0.0005 * row;
    text += number(t_s) + "," + (t_s < 0.3 ? "0,0," : "0.1,0.1,") + number(0.1 * std::max(0.0, t_s - 0.3)) +
            ",0,0\n";
  }
  const auto outcome = import_text(text, {"robot.wheel_base_m=0.3", "time.period_s=0.05"});
  INFO((outcome.conversion ? "" : outcome.conversion.error()));
  REQUIRE(outcome.conversion);
  CHECK(outcome.conversion->runs.front().period_s == 0.05);
}

TEST_CASE("Pixels beside a robot without any scale are asked for") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "t,pwm_left,pwm_right,x_px,y_px",
                                                [](const ForeignRow& row) {
                                                  return number(row.t_s) + "," +
                                                         number(400.0 * row.command_left) + "," +
                                                         number(400.0 * row.command_right) + in_image(row);
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  REQUIRE_FALSE(outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("--set reference.metres_per_pixel=0.003"));
}

TEST_CASE("Places that are said to be in metres and go much farther than the wheels are a doubt alone") {
  const auto drive = foreign_drive();
  auto settings = seen_settings;
  settings.back() = "wheels.metres_per_count=0.0001";
  const auto outcome = import_seen(
      drive, "x [m],y [m],theta",
      [](const ForeignRow& row) { return field(row.x) + field(row.y) + field(row.theta); }, settings);
  CHECK(outcome.doubts("which are said to be in metres, go"));
  CHECK(outcome.understood.mapping.reference->unit == "m");
}

TEST_CASE("Commands that are speeds show how far a pixel is where there are no wheels") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(foreign_text(drive, "t,cmd_left,cmd_right,x_px,y_px,theta",
                                                [](const ForeignRow& row) {
                                                  return number(row.t_s) + field(row.command_left) +
                                                         field(row.command_right) + in_image(row) +
                                                         field(row.theta);
                                                }),
                                   seen_settings);
  CHECK_THAT(*outcome.understood.mapping.reference->metres_per_pixel, WithinRel(1.0 / 310.0, 0.1));
  CHECK(outcome.found("a pixel is"));
}

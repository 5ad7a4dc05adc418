// Headings in forms that their names do not tell.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

ImportOutcome import_with_headings(const ForeignDrive& drive, const std::string& names,
                                   const std::function<std::string(const ForeignRow&)>& pose,
                                   bool gives_scale = true) {
  std::vector<std::string> settings{"robot.wheel_base_m=0.3"};
  if (gives_scale) settings.push_back("wheels.metres_per_count=0.0005");
  return import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right," + names,
                                  [&](const ForeignRow& row) {
                                    return number(row.t_s) + "," + number(row.command_left) + "," +
                                           number(row.command_right) + "," + counts(row) + "," + pose(row);
                                  }),
                     settings);
}

double largest_heading_error_rad(const ImportOutcome& outcome, const ForeignDrive& drive) {
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  double largest = 0.0;
  const auto& samples = outcome.conversion->runs.front().samples;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    REQUIRE(samples[k].reference_theta_rad);
    largest = std::max(largest, std::abs(std::remainder(*samples[k].reference_theta_rad - drive.rows[k].theta,
                                                        2.0 * 3.14159265358979)));
  }
  return largest;
}

std::string quaternion_of(const ForeignRow& row) {
  return number(std::cos(0.5 * row.theta)) + ",0.001,0.002," + number(std::sin(0.5 * row.theta));
}

}  // namespace

TEST_CASE("q0 to q3 are a quaternion whose real part stands first") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome = import_with_headings(drive, "x,y,q0,q1,q2,q3", [](const ForeignRow& row) {
    return number(row.x) + "," + number(row.y) + "," + quaternion_of(row);
  });
  CHECK(largest_heading_error_rad(outcome, drive) < 0.01);
}

TEST_CASE("A compass gives clockwise degrees") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome = import_with_headings(drive, "compass_deg", [](const ForeignRow& row) {
    return number(std::fmod(720.0 - row.theta * 57.29577951308232, 360.0));
  });
  CHECK(largest_heading_error_rad(outcome, drive) < 0.01);
}

TEST_CASE("Headings that start again behind 360 are in degrees") {
  const ForeignDrive drive = foreign_drive(2400);
  const ImportOutcome outcome = import_with_headings(drive, "imuHeading", [](const ForeignRow& row) {
    return number(std::remainder(170.0 + row.theta * 57.29577951308232, 360.0));
  });
  CHECK(outcome.understood.mapping.reference->angle_unit == "deg");
}

TEST_CASE("A marker off the axle does not change how far a count goes") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome = import_with_headings(
      drive, "x,y,theta",
      [](const ForeignRow& row) {
        return number(row.x + 0.15 * std::cos(row.theta)) + "," + number(row.y + 0.15 * std::sin(row.theta)) +
               "," + number(row.theta);
      },
      false);
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  CHECK_THAT(outcome.conversion->runs.front().metres_per_tick->left,
             WithinRel(ForeignDrive::metres_per_count, 0.003));
}

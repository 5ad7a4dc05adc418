// What a reference says of the scale of the counts.
#include "model/gap/candidates/testability.hpp"
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

constexpr double reached = 0.9;  // of the speed that is asked for

std::string asked(const ForeignRow& row) {
  return number(row.t_s) + "," + number(row.command_left / reached) + "," +
         number(row.command_right / reached) + "," + counts(row);
}

bool can_show_distance_scale(const ImportOutcome& outcome) {
  REQUIRE(outcome.conversion);
  const auto untestable = gap::testability(outcome.conversion->runs).untestable;
  return std::ranges::none_of(untestable,
                              [](const gap::Untestable& one) { return one.effect == "distance_scale"; });
}

}  // namespace

TEST_CASE("Where no one states how far a count goes, the reference says it before the commands do") {
  const ForeignDrive drive = foreign_drive();
  const std::vector<std::string> base{"robot.wheel_base_m=0.3"};
  const auto by_commands = import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right",
                                                    [](const ForeignRow& row) { return asked(row); }),
                                       base);
  REQUIRE(by_commands.understood.mapping.wheels->metres_per_count);
  CHECK_THAT(*by_commands.understood.mapping.wheels->metres_per_count,
             WithinRel(ForeignDrive::metres_per_count / reached, 0.02));

  const std::string header = "t,cmd_left,cmd_right,enc_left,enc_right,ref_x,ref_y,ref_theta";
  for (const double degrees : {1.0, 57.295779513}) {
    for (const double millimetres : {1.0, 1000.0}) {
      INFO(degrees << " " << millimetres);
      const auto by_reference =
          import_text(foreign_text(drive, header,
                                   [&](const ForeignRow& row) {
                                     return asked(row) + "," + number(millimetres * row.x) + "," +
                                            number(millimetres * row.y) + "," + number(degrees * row.theta);
                                   }),
                      base);
      REQUIRE(by_reference.understood.mapping.wheels->metres_per_count);
      CHECK_THAT(*by_reference.understood.mapping.wheels->metres_per_count,
                 WithinRel(ForeignDrive::metres_per_count, 0.001));
      CHECK(by_reference.found("so that the wheels go as far as the reference"));
      CHECK_FALSE(by_reference.found("so that a wheel reaches the speed that it is asked for"));
      CHECK_FALSE(can_show_distance_scale(by_reference));
    }
  }
}

TEST_CASE("A scale that is stated stays, whatever the reference says") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(
      foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right,ref_x,ref_y,ref_theta",
                   [](const ForeignRow& row) {
                     return asked(row) + "," + number(row.x) + "," + number(row.y) + "," + number(row.theta);
                   }),
      {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.00052"});
  CHECK(outcome.understood.mapping.wheels->metres_per_count == 0.00052);
  CHECK(can_show_distance_scale(outcome));
}

TEST_CASE("A log that is all in millimetres is told from one in metres by the wheel base") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_text(
      foreign_text(drive, "",
                   [](const ForeignRow& row) {
                     return number(row.t_s) + "," + std::to_string(std::lround(1000.0 * row.command_left)) +
                            "," + std::to_string(std::lround(1000.0 * row.command_right)) + "," +
                            counts(row) + "," + number(1000.0 * row.x) + "," + number(1000.0 * row.y) + "," +
                            number(row.theta);
                   }),
      {"robot.wheel_base_m=0.3", "command.unit=mm/s"});
  check_same(outcome, drive, 1e-3, 0.001);
  CHECK(outcome.found("whose places are in mm"));
}

TEST_CASE(
    "Wheels that tell their angle get their radius from the reference, and commands in rad/s are known") {
  const ForeignDrive drive = foreign_drive();
  constexpr double radius_m = 0.0325;
  const auto outcome = import_text(
      foreign_text(drive, "t,w_l,w_r,phi_l,phi_r,x,y,theta",
                   [](const ForeignRow& row) {
                     const auto angle = [](std::int64_t count) {
                       return number(static_cast<double>(count) * ForeignDrive::metres_per_count / radius_m);
                     };
                     return number(row.t_s) + "," + number(row.command_left / radius_m) + "," +
                            number(row.command_right / radius_m) + "," + angle(row.counts_left) + "," +
                            angle(row.counts_right) + "," + number(row.x) + "," + number(row.y) + "," +
                            number(row.theta);
                   }),
      {"robot.wheel_base_m=0.3"});
  REQUIRE(outcome.understood.mapping.wheels->wheel_radius_m);
  CHECK_THAT(*outcome.understood.mapping.wheels->wheel_radius_m, WithinRel(radius_m, 0.001));
  CHECK(outcome.understood.mapping.command->unit == "rad/s");
}

TEST_CASE("Commands that are no metres per second beside a reference are doubted") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right,x,y,theta",
                               [](const ForeignRow& row) {
                                 return number(row.t_s) + "," + number(row.command_left / 0.5) + "," +
                                        number(row.command_right / 0.5) + "," + counts(row) + "," +
                                        number(row.x) + "," + number(row.y) + "," + number(row.theta);
                               }),
                  {"robot.wheel_base_m=0.3"});
  CHECK(outcome.doubts("times as fast as commanded: the commands may be a duty"));
  CHECK_THAT(*outcome.understood.mapping.wheels->metres_per_count,
             WithinRel(ForeignDrive::metres_per_count, 0.001));
}

TEST_CASE("A pose that is logged more often than it is measured gives the scale to a per cent") {
  ForeignDrive drive = foreign_drive();
  for (std::size_t k = 0; k < drive.rows.size(); ++k) {
    const ForeignRow& measured = drive.rows[k - k % 10];
    drive.rows[k].x = measured.x;
    drive.rows[k].y = measured.y;
    drive.rows[k].theta = measured.theta;
  }
  const auto outcome = import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right,x,y,theta",
                                                [](const ForeignRow& row) {
                                                  return asked(row) + "," + number(row.x) + "," +
                                                         number(row.y) + "," + number(row.theta);
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  CHECK_THAT(*outcome.understood.mapping.wheels->metres_per_count,
             WithinRel(ForeignDrive::metres_per_count, 0.01));
}

// Numbers that a tracker says in place of a pose that it has lost.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> lost_settings{"robot.wheel_base_m=0.3"};

// Each 37th row and the three behind it.
bool is_lost(std::size_t row) {
  return row % 37 < 4 && row > 37;
}

// Poses of a robot that started away from the origin of its tracker.
std::string pose_or(const ForeignRow& row, bool lost, double instead) {
  if (lost) return number(instead) + "," + number(instead) + "," + number(instead);
  return number(1.0 + row.x) + "," + number(2.0 + row.y) + "," + number(row.theta);
}

ImportOutcome import_lost(const ForeignDrive& drive, const std::string& header, double instead) {
  std::size_t row_number = 0;
  return import_text(foreign_text(drive, header,
                                  [&](const ForeignRow& row) {
                                    return number(row.t_s) + "," + number(row.command_left) + "," +
                                           number(row.command_right) + "," + counts(row) + "," +
                                           pose_or(row, is_lost(row_number++), instead);
                                  }),
                     lost_settings);
}

void check_lost_rows(const ImportOutcome& outcome, const ForeignDrive& drive) {
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  const DriveLog& log = outcome.conversion->runs.front();
  REQUIRE(log.samples.size() == drive.rows.size());
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    INFO(row);
    REQUIRE(log.samples[row].reference_x_m.has_value() != is_lost(row));
    REQUIRE(log.samples[row].reference_theta_rad.has_value() != is_lost(row));
    if (!is_lost(row)) CHECK_THAT(*log.samples[row].reference_x_m, WithinAbs(1.0 + drive.rows[row].x, 1e-3));
  }
}

}  // namespace

TEST_CASE("A pose of 0, -1, -999 or 9999 for a few rows is none, in columns with names and without") {
  const auto drive = foreign_drive();
  for (const double instead : {0.0, -1.0, -999.0, 9999.0}) {
    for (const char* header : {"t,cmd_left,cmd_right,enc_left,enc_right,mocap_x,mocap_y,mocap_yaw", ""}) {
      INFO(instead << " " << header);
      const auto outcome = import_lost(drive, header, instead);
      check_lost_rows(outcome, drive);
      CHECK(outcome.remarks("the pose is lost"));
    }
  }
}

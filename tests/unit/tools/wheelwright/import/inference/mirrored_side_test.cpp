// A motor that is mounted the other way round, where no places show it.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

ImportOutcome import_mirrored(const ForeignDrive& drive, bool is_right, const std::string& names,
                              const std::function<std::string(const ForeignRow&)>& seen) {
  const double left = is_right ? 1.0 : -1.0;
  return import_text(foreign_text(drive, "t,leftPower,rightPower,leftPos,rightPos" + names,
                                  [&](const ForeignRow& row) {
                                    return number(row.t_s) + field(left * row.command_left / 0.5) +
                                           field(-left * row.command_right / 0.5) +
                                           field(left * static_cast<double>(row.counts_left)) +
                                           field(-left * static_cast<double>(row.counts_right)) + seen(row);
                                  }),
                     {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005", "command.full_scale=1",
                      "command.full_scale_m_s=0.5"});
}

}  // namespace

TEST_CASE("Headings alone show which motor is mounted the other way round, in degrees or radians") {
  const ForeignDrive drive = foreign_drive();
  for (const double unit : {1.0, 180.0 / std::numbers::pi}) {
    for (const bool is_right : {true, false}) {
      CAPTURE(unit, is_right);
      const auto outcome = import_mirrored(drive, is_right, ",imuHeading", [unit](const ForeignRow& row) {
        return field(unit * std::remainder(row.theta, 2.0 * std::numbers::pi));
      });
      check_same(outcome, drive);
      CHECK(outcome.understood.mapping.command->right_reversed == is_right);
      CHECK(outcome.understood.mapping.wheels->left_reversed != is_right);
    }
  }
}

TEST_CASE("Without a reference a robot that is sent in circles most of the time is doubted, and not turned") {
  const auto nothing_seen = [](const ForeignRow&) { return std::string(); };
  const auto mirrored =
      import_mirrored(drive_by([](std::size_t k) { return 0.1 + 0.1 * static_cast<double>(k / 40 % 2); },
                               [](std::size_t k) { return 0.1 + 0.1 * static_cast<double>(k / 55 % 2); }),
                      true, "", nothing_seen);
  CHECK(mirrored.doubts("--set command.reversed=right --set wheels.reversed=right"));
  CHECK_FALSE(mirrored.understood.mapping.command->right_reversed);
  const auto straight = import_seen(foreign_drive(), "other", [](const ForeignRow&) { return ",0"; });
  CHECK_FALSE(straight.doubts("opposite ways"));
}

TEST_CASE("A gyro alone shows it, too, whatever its offset at rest") {
  const ForeignDrive drive = foreign_drive();
  double last_rad = 0.0;
  const auto outcome = import_mirrored(drive, true, ",gyro_z", [&](const ForeignRow& row) {
    const double rate = (row.theta - last_rad) / 0.05;
    last_rad = row.theta;
    return field(rate + 0.03);
  });
  check_same(outcome, drive);
  CHECK(outcome.understood.mapping.command->right_reversed);
}

#include "model/brain/commanded_drive.hpp"

#include "model/brain/manoeuvre.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

// 0.2 m/s for three rows, backwards for two, at 0.1 s.
DriveLog forth_and_back() {
  DriveLog log;
  log.period_s = 0.1;
  for (int row = 0; row < 5; ++row) {
    const double speed = row < 3 ? 0.2 : -0.2;
    DriveSample& sample = log.samples.emplace_back();
    sample.t_s = 7.0 + 0.1 * row;
    sample.command_m_s = {speed, 0.5 * speed};
  }
  return log;
}

std::vector<double> left_commands(const CommandedDrive& drive, double period_s) {
  const auto manoeuvre = make_commanded_drive(drive, period_s);
  std::vector<double> commands;
  while (const auto order = manoeuvre->next({})) {
    CHECK(order->activity == Activity::commanded_drive);
    commands.push_back(order->speed_m_s.left);
  }
  return commands;
}

}  // namespace

TEST_CASE("The commands of a log begin with its first row and keep only what changes") {
  const CommandedDrive drive = commanded_drive_of(forth_and_back());
  REQUIRE(drive.rows.size() == 2);
  CHECK(drive.rows[0].t_s == 0.0);
  CHECK_THAT(drive.rows[1].t_s, WithinAbs(0.3, 1e-9));
  CHECK(drive.rows[1].command_m_s.right == -0.1);
  CHECK_THAT(drive.duration_s, WithinAbs(0.5, 1e-9));
}

TEST_CASE("At the period of the log a command is given as often as it stood there") {
  CHECK(left_commands(commanded_drive_of(forth_and_back()), 0.1) ==
        std::vector<double>{0.2, 0.2, 0.2, -0.2, -0.2});
}

TEST_CASE("At another period each command changes at the nearest tick and the drive takes as long") {
  const auto commands = left_commands(commanded_drive_of(forth_and_back()), 0.018);
  CHECK(commands.size() == 28);  // 0.504 s
  const auto changes = std::ranges::find(commands, -0.2);
  CHECK(changes - commands.begin() == 17);  // 0.306 s
}

TEST_CASE("A drive is given again from its start when it is driven again") {
  const auto manoeuvre = make_commanded_drive(commanded_drive_of(forth_and_back()), 0.1);
  while (manoeuvre->next({})) {
  }
  manoeuvre->restart();
  const auto first = manoeuvre->next({});
  REQUIRE(first);
  CHECK(first->speed_m_s.left == 0.2);
}

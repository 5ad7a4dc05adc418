// Commands that end while the robot is told to drive.
#include <cmath>

#include "config/load/text_format.hpp"
#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

constexpr std::size_t cycle_rows = 120;  // 3 s of commands, 3 s without
constexpr std::size_t said_rows = 60;

bool is_said(std::size_t k) {
  return k % cycle_rows < said_rows;
}

// Wheels that stop `rows` after the last command, where there is none.
ForeignDrive watched_drive(std::size_t rows) {
  const auto commanded = [rows](std::size_t k, double first, double second) {
    const std::size_t cycle = k / cycle_rows;
    if (k % cycle_rows > said_rows - 1 + rows) return 0.0;
    const bool begins = k % cycle_rows < said_rows / 2;
    return (begins ? first : second) + 0.02 * static_cast<double>(cycle % 4);
  };
  return drive_by([&](std::size_t k) { return commanded(k, 0.1, 0.2); },
                  [&](std::size_t k) { return commanded(k, 0.12, -0.1); });
}

ImportOutcome import_watched(const ForeignDrive& drive, const std::vector<std::string>& settings) {
  std::size_t k = 0;
  return import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right",
                                  [&k](const ForeignRow& row) {
                                    const std::string commands =
                                        is_said(k++) ? field(row.command_left) + field(row.command_right)
                                                     : ",,";
                                    return number(row.t_s) + commands + "," + counts(row);
                                  }),
                     settings);
}

}  // namespace

TEST_CASE(
    "A robot that stops by itself after the last command shows after what time, and its commands end there") {
  for (const auto& [rows, timeout_s] : {std::pair{std::size_t{10}, 0.5}, {std::size_t{20}, 1.0}}) {
    CAPTURE(timeout_s);
    const ForeignDrive drive = watched_drive(rows);
    const auto outcome = import_watched(drive, seen_settings);
    CHECK(outcome.found("the robot stops " + config::plain_number(timeout_s) + " s after"));
    check_same(outcome, drive);
    CHECK_FALSE(outcome.remarks("it is taken to hold"));
  }
}

TEST_CASE("Where the wheels go on, the last command holds, and the time may be stated against them") {
  const ForeignDrive drive = watched_drive(cycle_rows);
  const auto outcome = import_watched(drive, seen_settings);
  check_same(outcome, drive);
  CHECK(outcome.remarks("--set command.timeout_s"));
  std::vector<std::string> settings = seen_settings;
  settings.emplace_back("command.timeout_s=0.5");
  const auto stated = import_watched(drive, settings);
  REQUIRE(stated.conversion);
  CHECK(stated.conversion->runs.front().samples[said_rows + 40].command_m_s.left == 0.0);
}

// Commands that are never negative, about the number at which the wheels rest.
#include <cmath>
#include <cstdlib>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"
#include "tools/wheelwright/import/mapping/mapping_file.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> neutral_settings{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

// Whole numbers about `neutral`, `per_m_s` for each metre per second.
std::string about(double neutral, double per_m_s, double command_m_s) {
  return std::to_string(std::lround(neutral + per_m_s * command_m_s));
}

std::string wheels_about(double neutral, double per_m_s, const ForeignRow& row) {
  return number(row.t_s) + "," + about(neutral, per_m_s, row.command_left) + "," +
         about(neutral, per_m_s, row.command_right) + "," + counts(row);
}

ImportOutcome import_about(const ForeignDrive& drive, const std::string& header, double neutral,
                           double per_m_s, const std::vector<std::string>& settings = neutral_settings) {
  return import_text(
      foreign_text(drive, header, [&](const ForeignRow& row) { return wheels_about(neutral, per_m_s, row); }),
      settings);
}

double neutral_of(const ImportOutcome& outcome) {
  return outcome.understood.mapping.command->neutral;
}

}  // namespace

TEST_CASE("Pulses of a remote control are about the one at which the wheels rest") {
  const auto drive = foreign_drive();
  for (const char* header : {"t,rc_left,rc_right,enc_left,enc_right", ""}) {
    INFO(header);
    const auto outcome = import_about(drive, header, 1500.0, 800.0);
    check_same(outcome, drive, 0.006);
    CHECK(neutral_of(outcome) == 1500.0);
    CHECK(outcome.understood.mapping.command->full_scale == 500.0);
    CHECK(outcome.found("the wheels rest at a command of 1500"));
  }
}

TEST_CASE("A remote control whose sticks rest beside 1500 has the neutral at which the wheels rest") {
  const auto drive = foreign_drive();
  const auto outcome = import_about(drive, "t,servo_l,servo_r,enc_l,enc_r", 1487.0, 800.0);
  check_same(outcome, drive, 0.006);
  CHECK(neutral_of(outcome) == 1487.0);
}

TEST_CASE("A pulse width about 128 and the angle of a servo about 90 are signed") {
  const auto drive = foreign_drive();
  for (const double neutral : {128.0, 90.0}) {
    INFO(neutral);
    const auto outcome = import_about(drive, "t,pwm_l,pwm_r,enc_l,enc_r", neutral, 250.0);
    check_same(outcome, drive, 0.01);
    CHECK(neutral_of(outcome) == neutral);
    CHECK(outcome.understood.mapping.command->full_scale == neutral);
  }
}

TEST_CASE("Throttle and steering of a remote control are found with names and without") {
  const auto drive = foreign_drive();
  for (const char* header : {"t,throttle,steering,enc_left,enc_right", ""}) {
    INFO(header);
    const auto outcome = import_text(
        foreign_text(drive, header,
                     [](const ForeignRow& row) {
                       return number(row.t_s) + "," + about(1500.0, 800.0, row.linear()) + "," +
                              about(1500.0, 400.0, row.command_right - row.command_left) + "," + counts(row);
                     }),
        neutral_settings);
    check_same(outcome, drive, 0.01);
    CHECK(neutral_of(outcome) == 1500.0);
  }
}

TEST_CASE("Counts without a direction get that of commands about a neutral") {
  const auto drive = foreign_drive();
  std::int64_t left = 0;
  std::int64_t right = 0;
  ForeignRow before = drive.rows.front();
  const auto outcome = import_text(foreign_text(drive, "t,rc_left,rc_right,enc_left,enc_right",
                                                [&](const ForeignRow& row) {
                                                  left += std::abs(row.counts_left - before.counts_left);
                                                  right += std::abs(row.counts_right - before.counts_right);
                                                  before = row;
                                                  return number(row.t_s) + "," +
                                                         about(1500.0, 800.0, row.command_left) + "," +
                                                         about(1500.0, 800.0, row.command_right) + "," +
                                                         std::to_string(left) + "," + std::to_string(right);
                                                }),
                                   neutral_settings);
  check_same(outcome, drive, 0.01, 0.05);
  CHECK(neutral_of(outcome) == 1500.0);
}

TEST_CASE("A receiver that hears no pulse says 0, and the wheels are told to rest") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(drive, "t,rc_left,rc_right,enc_left,enc_right", [](const ForeignRow& row) {
    const auto pulse = [](double command_m_s) {
      return command_m_s == 0.0 ? std::string("0") : about(1500.0, 800.0, command_m_s);
    };
    return number(row.t_s) + "," + pulse(row.command_left) + "," + pulse(row.command_right) + "," +
           counts(row);
  });
  auto settings = neutral_settings;
  settings.emplace_back("command.neutral=1500");
  settings.emplace_back("command.full_scale_m_s=0.625");
  check_same(import_text(text, settings), drive, 0.006);
}

TEST_CASE("A stated neutral is taken off, also where the motion would not show it") {
  const auto drive = foreign_drive();
  auto settings = neutral_settings;
  settings.emplace_back("command.neutral=1490");
  const auto outcome = import_about(drive, "t,rc_left,rc_right,enc_left,enc_right", 1500.0, 800.0, settings);
  REQUIRE(outcome.conversion);
  CHECK(neutral_of(outcome) == 1490.0);
  CHECK(outcome.conversion->runs.front().samples.front().command_m_s.right > 0.0);  // 10 us beyond it
  CHECK_FALSE(outcome.found("the wheels rest"));
}

TEST_CASE("The dead zone of a duty that begins at 0 is no neutral") {
  ForeignDrive drive = foreign_drive();
  for (ForeignRow& row : drive.rows) {  // forward only: the wheels stand where they would go back
    row.command_left = std::max(0.0, row.command_left);
    row.command_right = std::max(0.0, row.command_right);
  }
  double left_m = 0.0;
  double right_m = 0.0;
  const auto text = foreign_text(drive, "t,pwm_l,pwm_r,enc_l,enc_r", [&](const ForeignRow& row) {
    const auto width = [](double command_m_s) {
      return command_m_s > 0.0 ? std::lround(70.0 + 300.0 * command_m_s) : 0L;
    };
    std::string line = number(row.t_s);
    for (const long column : {width(row.command_left), width(row.command_right), std::lround(left_m / 0.0005),
                              std::lround(right_m / 0.0005)}) {
      line += ",";
      line += std::to_string(column);
    }
    left_m += drive.period_s * row.command_left;
    right_m += drive.period_s * row.command_right;
    return line;
  });
  const auto outcome = import_text(text, neutral_settings);
  REQUIRE(outcome.conversion);
  CHECK(neutral_of(outcome) == 0.0);
}

TEST_CASE("A neutral survives the text of its mapping") {
  const auto outcome = import_about(foreign_drive(), "t,rc_left,rc_right,enc_left,enc_right", 1500.0, 800.0);
  const auto& entries = outcome.understood.inference.entries;
  const auto at = std::ranges::find(entries, "command.neutral", &import::MappingEntry::key);
  REQUIRE(at != entries.end());
  CHECK(import::to_mapping(entries, "log").command->neutral == 1500.0);
}

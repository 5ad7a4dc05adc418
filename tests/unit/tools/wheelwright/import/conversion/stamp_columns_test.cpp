// Times that a log holds in parts, or as steps, or as a logger of a language writes them.
#include <iomanip>
#include <sstream>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> base_only{"robot.wheel_base_m=0.3"};

std::string motion_of(const ForeignRow& row) {
  std::string line = number(row.command_left);
  line += ",";
  line += number(row.command_right);
  line += ",";
  return line + counts(row);
}

}  // namespace

TEST_CASE("Seconds and nanoseconds in two columns are one time") {
  const auto drive = foreign_drive();
  for (const char* names : {"header.stamp.sec,header.stamp.nanosec", "sec,nsec", "stamp_secs,stamp_nsecs"}) {
    INFO(names);
    const auto outcome =
        import_text(foreign_text(drive, std::string(names) + ",cmd_left,cmd_right,enc_left,enc_right",
                                 [](const ForeignRow& row) {
                                   const auto ns = static_cast<long long>(1e9 * row.t_s + 0.5);
                                   std::string line = std::to_string(1716212345 + ns / 1'000'000'000);
                                   line += ",";
                                   line += std::to_string(ns % 1'000'000'000);
                                   line += ",";
                                   return line + motion_of(row);
                                 }),
                    base_only);
    check_same(outcome, drive);
  }
}

TEST_CASE("A column of steps of time is summed, in its unit") {
  const auto drive = foreign_drive();
  for (const auto& [name, unit] : {std::pair{"dt", 1.0}, {"dt_ms", 1000.0}}) {
    INFO(name);
    const auto outcome =
        import_text(foreign_text(drive, std::string(name) + ",cmd_left,cmd_right,enc_left,enc_right",
                                 [&](const ForeignRow& row) {
                                   std::string line = number(unit * drive.period_s);
                                   line += ",";
                                   return line + motion_of(row);
                                 }),
                    base_only);
    check_same(outcome, drive);
  }
}

TEST_CASE("Lines of Python's logging are read, with their milliseconds behind a comma") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(
      foreign_text(drive, "",
                   [](const ForeignRow& row) {
                     const long ms = static_cast<long>(1e3 * row.t_s + 0.5);
                     std::ostringstream line;
                     line << std::setfill('0') << "2024-05-20 13:" << std::setw(2) << 39 + ms / 60000 << ':'
                          << std::setw(2) << ms / 1000 % 60 << ',' << std::setw(3) << ms % 1000
                          << " INFO:drive: cmd_l=" << row.command_left << " cmd_r=" << row.command_right
                          << " enc_l=" << row.counts_left << " enc_r=" << row.counts_right;
                     return line.str();
                   }),
      base_only);
  check_same(outcome, drive);
}

TEST_CASE("A wheel angle that starts again at each turn goes on, whatever its range") {
  const auto drive = foreign_drive();
  for (const double turn : {360.0, 6.283185307179586}) {
    INFO(turn);
    const auto angle = [turn](std::int64_t count) {
      const double turns =
          static_cast<double>(count) * ForeignDrive::metres_per_count / (2.0 * 3.14159265 * 0.035);
      return number(turn * (turns - std::floor(turns)));
    };
    const auto outcome = import_text(
        foreign_text(
            drive,
            turn > 100.0 ? "t,cmd_l,cmd_r,angle_l_deg,angle_r_deg" : "t,cmd_l,cmd_r,angle_l_rad,angle_r_rad",
            [&](const ForeignRow& row) {
              std::string line = number(row.t_s);
              for (const std::string& value : {number(row.command_left), number(row.command_right),
                                               angle(row.counts_left), angle(row.counts_right)}) {
                line += ",";
                line += value;
              }
              return line;
            }),
        {"robot.wheel_base_m=0.3", "wheels.wheel_radius_m=0.035"});
    check_same(outcome, drive);
  }
}

TEST_CASE("The 12 bits of a magnetic encoder wrap, stated or not") {
  const auto drive = foreign_drive();
  for (const bool is_stated : {true, false}) {
    INFO(is_stated);
    std::vector<std::string> settings{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0000625"};
    if (is_stated) settings.emplace_back("wheels.bits=12");
    const auto raw = [](std::int64_t count) { return std::to_string(((8 * count) % 4096 + 4096) % 4096); };
    const auto outcome = import_text(
        foreign_text(drive, "t,cmd_l,cmd_r,enc_l,enc_r",
                     [&](const ForeignRow& row) {
                       std::string line = number(row.t_s);
                       for (const std::string& value : {number(row.command_left), number(row.command_right),
                                                        raw(row.counts_left), raw(row.counts_right)}) {
                         line += ",";
                         line += value;
                       }
                       return line;
                     }),
        settings);
    check_same(outcome, drive);
  }
}

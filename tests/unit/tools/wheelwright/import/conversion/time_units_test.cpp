// Time columns in units that a file does not state.
#include <array>
#include <cmath>
#include <cstdio>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;
using import::TimeUnit;

namespace {

const std::vector<std::string> known{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

// A drive whose time stands in some form.
std::string timed(const ForeignDrive& drive, const std::string& name,
                  const std::function<std::string(const ForeignRow&)>& time) {
  return foreign_text(drive, name + ",cmd_left,cmd_right,ticks_left,ticks_right", [&](const ForeignRow& row) {
    return time(row) + "," + number(row.command_left) + "," + number(row.command_right) + "," + counts(row);
  });
}

std::string decimals(double value, int places) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", places, value);
  return text.data();
}

std::string hundredths(const ForeignRow& row) {
  return std::to_string(std::lround(100.0 * row.t_s));
}

}  // namespace

TEST_CASE("Hundredths of a second are told from milliseconds by the speed of the wheels") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(timed(drive, "t", hundredths), known);
  check_same(outcome, drive);
  CHECK(outcome.found("hundredths of a second"));
  const auto fast = foreign_drive(1200, 0.005, 0.00005);
  const auto milliseconds = import_text(
      timed(fast, "t", [](const ForeignRow& row) { return std::to_string(std::lround(1e3 * row.t_s)); }),
      {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.00005"});
  CHECK(milliseconds.understood.mapping.time.unit == TimeUnit::ms);
  CHECK(milliseconds.understood.inference.doubts.empty());
}

TEST_CASE("Time that may be milliseconds or hundredths is doubted where nothing tells them apart") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(timed(drive, "t", hundredths), {"robot.wheel_base_m=0.3"});
  CHECK(outcome.doubts("--set time.unit=ms or time.unit=cs"));
  const auto said = import_text(timed(drive, "t", hundredths), {"robot.wheel_base_m=0.3", "time.unit=cs"});
  CHECK_FALSE(said.doubts("time.unit"));
  check_same(said, drive, 1e-3, 0.03);
}

TEST_CASE(
    "The unit in the name of a time stands where it gives a rate, also where the steps suggest another") {
  auto slow = foreign_drive();
  for (auto& row : slow.rows) row.t_s *= 20.0;  // a row a second
  slow.period_s = 1.0;
  for (const auto& [name, unit] : {std::pair{"time_ms", TimeUnit::ms}, {"t [ms]", TimeUnit::ms}}) {
    const auto outcome = import_text(
        timed(slow, name, [](const ForeignRow& row) { return std::to_string(std::lround(1e3 * row.t_s)); }),
        {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
    INFO(name);
    CHECK(outcome.understood.mapping.time.unit == unit);
    REQUIRE(outcome.conversion);
    CHECK_THAT(outcome.conversion->runs.front().period_s, WithinAbs(1.0, 1e-6));
  }
  const auto wrong =
      import_text(timed(foreign_drive(), "time_s",
                        [](const ForeignRow& row) { return std::to_string(std::lround(1e3 * row.t_s)); }),
                  known);
  check_same(wrong, foreign_drive());
  CHECK(wrong.found("not in seconds as its name says"));
}

TEST_CASE("Day numbers of a spreadsheet and of MATLAB are days") {
  const auto drive = foreign_drive();
  for (const double day : {45356.5, 739311.5, 0.5}) {
    INFO(day);
    const auto outcome = import_text(
        timed(drive, "Time", [&](const ForeignRow& row) { return decimals(day + row.t_s / 86400.0, 10); }),
        known);
    check_same(outcome, drive);
    CHECK(outcome.found("time is in days"));
  }
}

TEST_CASE("A counter of milliseconds or microseconds that starts again behind 2^32 goes on") {
  const auto drive = foreign_drive();
  for (const auto& [unit, per_s] : {std::pair{TimeUnit::us, 1e6}, {TimeUnit::ms, 1e3}}) {
    const auto outcome =
        import_text(timed(drive, "t",
                          [per_s = per_s](const ForeignRow& row) {
                            const auto start = 4294967296LL - std::llround(30.02 * per_s);
                            return std::to_string((start + std::llround(row.t_s * per_s)) % 4294967296LL);
                          }),
                    known);
    INFO(per_s);
    CHECK(outcome.understood.mapping.time.unit == unit);
    check_same(outcome, drive);
    CHECK(outcome.remarks("line 603: the counter of time starts again behind 42949"));
  }
}

TEST_CASE("A clock that starts again elsewhere than at the end of a counter begins a new run") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(timed(drive, "t",
                                         [](const ForeignRow& row) {
                                           const double t = row.t_s < 30.0 ? row.t_s : row.t_s - 30.0;
                                           return std::to_string(std::lround(1e6 * t));
                                         }),
                                   known);
  REQUIRE(outcome.conversion);
  CHECK(outcome.conversion->runs.size() == 2);
}

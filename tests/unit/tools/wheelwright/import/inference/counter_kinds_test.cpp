// Counters of other robots: set to zero in mid-log, without a sign, per row, per second, of too few bits.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"
#include "tools/wheelwright/import/conversion/counter_resets.hpp"
#include "tools/wheelwright/import/conversion/repair_checks.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> known{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

std::string with_wheels(const ForeignDrive& drive, const std::string& names,
                        const std::function<std::string(std::size_t)>& wheels) {
  std::size_t k = 0;
  return foreign_text(drive, "t,cmd_left,cmd_right," + names, [&](const ForeignRow& row) {
    return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
           wheels(k++);
  });
}

std::string steps(const ForeignDrive& drive, std::size_t k, double factor) {
  const auto& now = drive.rows[k];
  const auto& before = drive.rows[k == 0 ? 0 : k - 1];
  const auto text = [&](std::int64_t step) {
    return factor == 1.0 ? std::to_string(step) : number(factor * static_cast<double>(step));
  };
  return text(now.counts_left - before.counts_left) + "," + text(now.counts_right - before.counts_right);
}

// Counts of an encoder with one channel, which counts up whichever way the wheel turns.
struct UnsignedCounter {
  std::int64_t left = 0;
  std::int64_t right = 0;

  std::string next(const ForeignDrive& drive, std::size_t k) {
    if (k > 0) {
      left += std::abs(drive.rows[k].counts_left - drive.rows[k - 1].counts_left);
      right += std::abs(drive.rows[k].counts_right - drive.rows[k - 1].counts_right);
    }
    return std::to_string(left) + "," + std::to_string(right);
  }
};

}  // namespace

TEST_CASE("A counter that was set to zero in mid-log begins a new run, and adds no travel") {
  const auto drive = foreign_drive();
  const auto& zero = drive.rows[700];
  const auto outcome = import_text(with_wheels(drive, "ticks_left,ticks_right",
                                               [&](std::size_t k) {
                                                 auto row = drive.rows[k];
                                                 if (k < 700) return counts(row);
                                                 row.counts_left -= zero.counts_left;
                                                 row.counts_right -= zero.counts_right;
                                                 return counts(row);
                                               }),
                                   known);
  REQUIRE(outcome.conversion);
  CHECK(outcome.remarks("line 702: the counts start again from zero"));
  REQUIRE(outcome.conversion->runs.size() == 2);
  CHECK(outcome.conversion->runs[0].samples.size() == 700);
  CHECK(outcome.conversion->runs[1].samples.size() == 500);
  CHECK_FALSE(outcome.doubts(""));
}

TEST_CASE("A single zero, a wrap and a wheel that comes back are no counter that was set to zero") {
  std::vector<double> travel(400);
  for (int k = 0; k < 400; ++k) travel[static_cast<std::size_t>(k)] = k < 200 ? 5.0 * k : 5.0 * (400 - k);
  CHECK(import::counter_resets(travel).empty());
  travel[150] = 0.0;
  CHECK(import::counter_resets(travel).empty());
  for (int k = 0; k < 400; ++k) travel[static_cast<std::size_t>(k)] = (900 * k) % 65536;
  CHECK(import::counter_resets(travel).empty());
}

TEST_CASE("Counts without a direction get that of the command where it explains them") {
  const auto drive = foreign_drive();
  UnsignedCounter counter;
  const auto text =
      with_wheels(drive, "ticks_left,ticks_right", [&](std::size_t k) { return counter.next(drive, k); });
  const auto outcome = import_text(text, known);
  check_same(outcome, drive, 1e-3, 0.05);
  CHECK(outcome.found("hold no direction"));
  CHECK(outcome.understood.inference.doubts.empty());
  const auto counted = import_text(text, {known[0], known[1], "wheels.direction=counted"});
  CHECK_FALSE(counted.found("hold no direction"));
}

TEST_CASE("Counts without a direction are doubted where the command does not explain them") {
  auto drive = foreign_drive();
  unsigned state = 7;
  for (auto& row : drive.rows) {
    state = state * 1664525U + 1013904223U;
    const double other = (state >> 16U) % 2 == 0 ? 0.2 : -0.2;
    row.command_left = row.command_right = other;
  }
  UnsignedCounter counter;
  const auto text =
      with_wheels(drive, "ticks_left,ticks_right", [&](std::size_t k) { return counter.next(drive, k); });
  const auto outcome = import_text(text, known);
  CHECK(outcome.doubts("have lost their sign"));
}

TEST_CASE("Counts of each row are told from a running count by the motion") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(
      with_wheels(drive, "enc_left,enc_right", [&](std::size_t k) { return steps(drive, k, 1.0); }), known);
  check_same(outcome, drive);
  CHECK(outcome.found("travel of each row"));
}

TEST_CASE("Counts per second are speeds of the wheels") {
  const auto drive = foreign_drive();
  for (const char* names : {"ticks_left_per_s,ticks_right_per_s", "enc_left [ticks/s],enc_right [ticks/s]",
                            "left_cps,right_cps", "left_qpps,right_qpps"}) {
    INFO(names);
    const auto outcome =
        import_text(with_wheels(drive, names, [&](std::size_t k) { return steps(drive, k, 20.0); }), known);
    CHECK(outcome.understood.mapping.wheels->unit == "counts/s");
    check_same(outcome, drive);
  }
  const auto unscaled = import_text(
      with_wheels(drive, "left_cps,right_cps", [&](std::size_t k) { return steps(drive, k, 20.0); }),
      {"robot.wheel_base_m=0.3"});
  check_same(unscaled, drive, 1e-3, 0.03);
}

TEST_CASE("Commands in counts per second are speeds by the distance of a count") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(drive, "t,target_qpps_left,target_qpps_right,enc_left,enc_right",
                                 [&](const ForeignRow& row) {
                                   return number(row.t_s) + "," + number(row.command_left / 0.0005) + "," +
                                          number(row.command_right / 0.0005) + "," + counts(row);
                                 });
  check_same(import_text(text, known), drive, 2e-3);
}

TEST_CASE("A counter of 8 bits that goes around between rows goes as the command predicts") {
  const auto drive = foreign_drive(1200, 0.05, 0.00004);  // 300 counts a row at 0.24 m/s
  const auto byte = [](std::int64_t count) { return std::to_string(((count % 256) + 256) % 256); };
  const auto outcome = import_text(with_wheels(drive, "ticks_left,ticks_right",
                                               [&](std::size_t k) {
                                                 return byte(drive.rows[k].counts_left) + "," +
                                                        byte(drive.rows[k].counts_right);
                                               }),
                                   {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.00004"});
  CHECK(outcome.found("8 bits"));
  REQUIRE(outcome.conversion);
  const auto& samples = outcome.conversion->runs.front().samples;
  CHECK(samples.back().ticks->left - samples.front().ticks->left == drive.rows.back().counts_left);
  CHECK(samples.back().ticks->right - samples.front().ticks->right == drive.rows.back().counts_right);
}

TEST_CASE("A counter of 8 bits whose turns the command does not predict is said to be lost") {
  auto drive = foreign_drive(1200, 0.05, 0.00004);
  for (auto& row : drive.rows) row.command_left = row.command_right = row.t_s < 30.0 ? 0.2 : 0.1;
  const auto byte = [](std::int64_t count) { return std::to_string(((count % 256) + 256) % 256); };
  const auto outcome = import_text(with_wheels(drive, "ticks_left,ticks_right",
                                               [&](std::size_t k) {
                                                 return byte(drive.rows[k].counts_left) + "," +
                                                        byte(drive.rows[k].counts_right);
                                               }),
                                   {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.00004"});
  CHECK(outcome.doubts("what the wheels did is unknown"));
}

TEST_CASE("A drive log whose counts start again from zero is one that import has to put right") {
  const auto drive = foreign_drive();
  auto outcome = import_text(
      with_wheels(drive, "ticks_left,ticks_right", [&](std::size_t k) { return counts(drive.rows[k]); }),
      known);
  REQUIRE(outcome.conversion);
  auto& run = outcome.conversion->runs.front();
  CHECK_FALSE(import::find_repair(outcome.conversion->runs));
  const auto zero = *run.samples[700].ticks;
  for (std::size_t k = 700; k < run.samples.size(); ++k) {
    run.samples[k].ticks->left -= zero.left;
    run.samples[k].ticks->right -= zero.right;
  }
  CHECK(import::find_repair(outcome.conversion->runs) == "counts that start again from zero");
}

TEST_CASE("A run that is too short to predict its counter says that the short way was taken") {
  const auto drive = foreign_drive(40);
  const auto outcome = import_text(
      with_wheels(drive, "ticks_left,ticks_right", [&](std::size_t k) { return counts(drive.rows[k]); }),
      {known[0], known[1], "wheels.bits=8", "wheels.unwrap=command"});
  CHECK(outcome.remarks("taken the short way"));
}

TEST_CASE(
    "The angle of an absolute encoder that goes around in counts is a counter, and one in degrees is none") {
  const ForeignDrive drive = foreign_drive(1200, 0.05, 0.00005);
  const auto around = [](std::int64_t count) { return std::to_string(((count % 4096) + 4096) % 4096); };
  const auto outcome = import_text(foreign_text(drive, "t,cmd_left,cmd_right,angle_left,angle_right",
                                                [&](const ForeignRow& row) {
                                                  return number(row.t_s) + "," + number(row.command_left) +
                                                         "," + number(row.command_right) + "," +
                                                         around(row.counts_left) + "," +
                                                         around(row.counts_right);
                                                }),
                                   {"robot.wheel_base_m=0.3"});
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  const import::WheelMapping& wheels = *outcome.understood.mapping.wheels;
  CHECK(wheels.kind == import::WheelKind::counts);
  CHECK_THAT(*wheels.metres_per_count, WithinRel(0.00005, 0.02));
}

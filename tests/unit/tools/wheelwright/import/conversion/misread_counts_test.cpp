// Counts that a fault on the bus took for a row or a few.
#include <set>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"
#include "tools/wheelwright/import/conversion/misread_counts.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::set<std::size_t> faulty_rows{200, 201, 340, 500, 650, 651, 652, 900};

ImportOutcome import_with_faults(const std::string& misread, std::int64_t start = 3000, int bits = 40) {
  const ForeignDrive drive = foreign_drive();
  const auto shown = [&](std::int64_t count) {
    return std::to_string((20 * count + start) % (std::int64_t{1} << bits));
  };
  std::string text = "t,cmd_left,cmd_right,enc_left,enc_right\n";
  for (std::size_t k = 0; k < drive.rows.size(); ++k) {
    const ForeignRow& row = drive.rows[k];
    text += number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
            (faulty_rows.contains(k) ? misread + "," + misread
                                     : shown(row.counts_left) + "," + shown(row.counts_right)) +
            "\n";
  }
  return import_text(text, {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.000025"});
}

void check_left_out(const ImportOutcome& outcome) {
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  REQUIRE(outcome.conversion->runs.size() == 1);
  const DriveLog& log = outcome.conversion->runs.front();
  const ForeignDrive drive = foreign_drive();
  REQUIRE(log.samples.size() == drive.rows.size());
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    if (faulty_rows.contains(k)) {
      CHECK_FALSE(log.samples[k].ticks);
    } else {
      REQUIRE(log.samples[k].ticks);
      CHECK(log.samples[k].ticks->left - log.samples[0].ticks->left == 20 * drive.rows[k].counts_left);
    }
  }
  CHECK(outcome.remarks("such rows) and goes on where it was: not read"));
}

}  // namespace

TEST_CASE("Counts of 0, -1 or all ones for a row or a few are left out, and the counter goes on") {
  for (const char* misread : {"0", "-1", "65535", "4294967295"}) {
    INFO(misread);
    check_left_out(import_with_faults(misread));
  }
}

TEST_CASE("Rows that were not read are left out of a counter that wraps") {
  check_left_out(import_with_faults("0", 31000, 16));
}

TEST_CASE("A counter that passes through zero or stands there, wraps or is reset was read") {
  std::vector<double> counts;
  for (int k = -300; k < 300; ++k) counts.push_back(7.0 * k);
  CHECK(import::misread_counts(counts).empty());
  for (double& count : counts) count = std::fmod(count + 1e6 * 65536.0, 65536.0);
  CHECK(import::misread_counts(counts).empty());
  std::vector<double> reset;
  for (int k = 0; k < 600; ++k) reset.push_back(7.0 * (k < 300 ? k + 100 : k - 300));
  CHECK(import::misread_counts(reset).empty());
}

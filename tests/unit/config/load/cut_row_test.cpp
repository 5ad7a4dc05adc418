// Files that lost their end.
#include "config/load/cut_row.hpp"

#include "config/load/csv_table.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/mrclam_files.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using config::has_lost_figures;

namespace {

template <typename Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const config::LogError& error) {
    return error.what();
  }
  return {};
}

std::string drive_log_refusal(const std::string& rows) {
  return refusal([&] {
    config::parse_drive_logs(
        "# wheel_base_m: 0.2\n# period_s: 1\n# metres_per_tick_left: 1e-4\n"
        "# metres_per_tick_right: 1e-4\nt,cmd_left,cmd_right,ticks_left,ticks_right\n" +
            rows,
        "run.csv");
  });
}

std::string table_refusal(const std::string& rows) {
  return refusal([&] { config::CsvTable::parse("t,x\n" + rows, "poses.csv"); });
}

std::string mrclam_refusal(const std::string& odometry) {
  return refusal([&] {
    config::parse_mrclam_run({"odometry.dat", odometry}, {"truth.dat", "1 0 0 0\n2 0 0 0\n"}, {});
  });
}

}  // namespace

TEST_CASE("Every reader refuses a last row that was cut short, with its line") {
  const std::string what = "the last row is cut short, without a line break at its end; delete it";
  CHECK(drive_log_refusal("0,0,0,1234,1234\n1,0,0,12") == "run.csv:7: " + what);
  CHECK(drive_log_refusal("0,0,0,1234,1234\n1,0,0,1234,12") == "run.csv:7: " + what);
  CHECK(table_refusal("0,16.25\n1") == "poses.csv:3: " + what);
  CHECK(table_refusal("0,16.25\n1,16.") == "poses.csv:3: " + what);
  CHECK(mrclam_refusal("1 0.1 0.2\n2 0.1") == "odometry.dat:2: " + what);
  CHECK(mrclam_refusal("1 0.1 10.25\n2 0.1 1") == "odometry.dat:2: " + what);
}

TEST_CASE("A file without a line break at its end is read where nothing speaks for a cut") {
  CHECK(drive_log_refusal("0,0,0,1234,1234\n1,0,0,1234,1234").empty());
  CHECK(drive_log_refusal("0,0,0,12,12").empty());
  CHECK(table_refusal("0,16.25\n1,16.2").empty());
  CHECK(table_refusal("0,0.2\n1,0").empty());  // a bare 0 for a robot that stops
  CHECK(mrclam_refusal("1 0.1 0.2\n2 0.1 0.2").empty());
}

TEST_CASE("A row that ends with a line break was not cut, whatever it holds") {
  CHECK(table_refusal("0,1000\n1,9\n").empty());
  CHECK_THAT(table_refusal("0,1000\n1\n"), ContainsSubstring("has 1 fields"));
}

TEST_CASE("Texts and numbers in other forms are not taken for cut ones") {
  CHECK_FALSE(has_lost_figures("pending", "100"));
  CHECK_FALSE(has_lost_figures("1e-3", "100"));
  CHECK_FALSE(has_lost_figures("", "100"));
  CHECK_FALSE(has_lost_figures("9", ""));
  CHECK(has_lost_figures("-1", "-12"));
}

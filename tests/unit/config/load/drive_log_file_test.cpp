#include "config/load/drive_log_file.hpp"

#include <cmath>
#include <filesystem>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using config::LogError;
using config::parse_drive_logs;

namespace {

const std::string header =
    "# wheelwright_drive_log: 1\n# wheel_base_m: 0.235\n# period_s: 0.018\n"
    "# metres_per_tick_left: 0.000444\n# metres_per_tick_right: 0.000445\n";

std::string error_of(const std::string& text) {
  try {
    parse_drive_logs(text, "run.csv");
  } catch (const LogError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("A log is read with its units, its empty fields and the columns that the format does not name") {
  const auto runs = parse_drive_logs(header +
                                         "t,cmd_left,cmd_right,ticks_left,ticks_right,ref_theta,mood\n"
                                         "0,0.1,-0.1,5,65536,,3\n0.018,,,6,65535,1.5,good\n",
                                     "run.csv");
  REQUIRE(runs.size() == 1);
  const DriveLog& log = runs.front();
  CHECK(log.wheel_base_m == 0.235);
  CHECK(log.metres_per_tick->right == 0.000445);
  REQUIRE(log.samples.size() == 2);
  CHECK_FALSE(log.samples[0].reference_theta_rad);
  CHECK(*log.samples[1].reference_theta_rad == 1.5);
  CHECK(log.samples[1].command_m_s.right == -0.1);
  CHECK(log.samples[1].ticks->right == 65535);
  REQUIRE(log.extra_columns.size() == 1);
  CHECK(log.extra_columns[0].name == "mood");
  CHECK(log.extra_columns[0].values[0] == 3.0);
  CHECK(std::isnan(log.extra_columns[0].values[1]));
  CHECK(log.extra_columns[0].texts == std::vector<std::string>{"3", "good"});
}

TEST_CASE("A clock that starts again begins a new run, and one that only steps back is refused") {
  const std::string columns = header + "t,cmd_left,cmd_right\n";
  CHECK(parse_drive_logs(columns + "0,0,0\n5,0,0\n0.01,0,0\n0.02,0,0\n", "run.csv").size() == 2);
  CHECK(error_of(columns + "0,0,0\n5,0,0\n4.9,0,0\n") ==
        "run.csv:9: time goes from 5 to 4.9 s, but must rise (a new run starts below 1 s)");
}

TEST_CASE("Every fault of a log is refused with its line") {
  const std::string columns = "t,cmd_left,cmd_right,ticks_left,ticks_right\n";
  CHECK(error_of(header + columns + "0,nan,0,1,1\n") ==
        "run.csv:7: 'cmd_left' is 'nan', but must be a number of at most 100 in size");
  CHECK_THAT(error_of(header + columns + "0,1e308,0,1,1\n"), ContainsSubstring("run.csv:7"));
  CHECK_THAT(error_of(header + columns + "0,0,0,1\n"), ContainsSubstring("has 4 fields"));
  CHECK_THAT(error_of(header + columns), ContainsSubstring("holds no samples"));
  CHECK_THAT(error_of(header), ContainsSubstring("header row"));
  CHECK_THAT(error_of(""), ContainsSubstring("header row"));
  CHECK_THAT(error_of(header + "t,cmd_left\n0,0\n"), ContainsSubstring("no column 'cmd_right'"));
  CHECK_THAT(error_of("# wheelwright_drive_log: 2\n"), ContainsSubstring("only version 1"));
  CHECK_THAT(error_of("t,cmd_left,cmd_right\n0,0,0\n1,0,0\n"), ContainsSubstring("wheel_base_m"));
  CHECK_THAT(error_of("# wheel_base_m: -1\n"), ContainsSubstring("from 0.001 to 10"));
}

TEST_CASE("What is saved is read back the same") {
  DriveLog log = parse_drive_logs(header +
                                      "t,cmd_left,cmd_right,ticks_left,ticks_right,ref_x,battery_v\n"
                                      "0,0.1,-0.1,5,-7,0.25,\n0.018,0.1,0,,,,14.5\n",
                                  "run.csv")
                     .front();
  const auto path = test::temporary_folder() / "wheelwright_saved_log.csv";
  config::save_drive_log(log, path);
  const DriveLog back = config::load_drive_log(path);
  std::filesystem::remove(path);
  REQUIRE(back.samples.size() == 2);
  CHECK(back.samples[0].ticks->right == -7);
  CHECK_FALSE(back.samples[1].ticks);
  CHECK(*back.samples[0].reference_x_m == 0.25);
  CHECK(*back.samples[1].battery_v == 14.5);
  CHECK(back.metres_per_tick->left == log.metres_per_tick->left);
}

TEST_CASE("A file that cannot be read is refused with the reason that is there") {
  const auto folder = test::temporary_folder();
  const auto refusal = [](const std::filesystem::path& path) {
    try {
      config::load_drive_logs(path);
    } catch (const config::LogError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal(folder) == folder.string() + ": is a folder, but must be a file");
  CHECK_THAT(refusal(folder / "none.csv"), ContainsSubstring("does the file exist?"));
}

TEST_CASE("A log of many columns is read in a time that grows as they do") {
  std::string names = "t,cmd_left,cmd_right";
  std::string row = "0,0,0";
  for (int i = 0; i < 100'000; ++i) {
    names += ",extra" + std::to_string(i);
    row += ",1";
  }
  CHECK(parse_drive_logs(header + names + "\n" + row + "\n", "run.csv").front().extra_columns.size() ==
        100'000);
}

TEST_CASE("Runs that would each repeat a long head are refused before they fill the memory") {
  std::string text = header;
  for (int i = 0; i < 20'000; ++i) text += "# note" + std::to_string(i) + ": x\n";
  text += "t,cmd_left,cmd_right\n";
  for (int i = 0; i < 1000; ++i) text += "0,0,0\n0.018,0,0\n";
  CHECK_THAT(error_of(text), ContainsSubstring("here begins run 50 of a log with 20000 further columns and "
                                               "lines of metadata"));
}

TEST_CASE("A field is quoted in a message as far as it helps, and printable") {
  const std::string names = "t,cmd_left,cmd_right\n";
  CHECK_THAT(error_of(header + names + "\x1b[2J,0,0\n"), ContainsSubstring("'t' is '\\x1b[2J', but must be"));
  CHECK(error_of(header + names + std::string(100'000, 'x') + ",0,0\n").size() < 300);
}

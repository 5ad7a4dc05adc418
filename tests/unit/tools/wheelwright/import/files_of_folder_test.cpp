// A folder of text files as one run.
#include <filesystem>
#include <fstream>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

void write_into(const std::filesystem::path& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name) << text;
}

}  // namespace

TEST_CASE("A folder of tables is one run, and its notes are left out and named") {
  const ForeignDrive drive = foreign_drive();
  const auto folder = temporary_folder() / "wheelwright_folder_of_tables";
  std::filesystem::create_directories(folder);
  write_into(folder, "cmd.csv", foreign_text(drive, "time,v,w", [](const ForeignRow& row) {
               return number(row.t_s) + "," + number(row.linear()) + "," +
                      number(row.angular(ForeignDrive::base_m));
             }));
  write_into(folder, "ticks.csv", foreign_text(drive, "time,left,right", [](const ForeignRow& row) {
               return number(row.t_s) + "," + counts(row);
             }));
  write_into(folder, "notes.txt", "floor: parquet, new battery\n");
  const auto understood = import::understand(
      {{folder},
       std::nullopt,
       import::GivenMapping("", {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"})});
  if (!understood) FAIL(understood.error());
  CHECK(has_words(understood->inference.findings, "notes.txt"));
  auto conversion = import::to_runs(*understood);
  check_same({*understood, std::move(conversion)}, drive);
}

TEST_CASE("Of a run of the daemon the drive log is taken, and nothing that was computed from it") {
  const ForeignDrive drive = foreign_drive();
  const auto folder = temporary_folder() / "wheelwright_folder_of_run";
  std::filesystem::create_directories(folder);
  write_into(folder, "drive_log.csv",
             foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [](const ForeignRow& row) {
               return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) +
                      "," + counts(row);
             }));
  write_into(folder, "pose_log.csv", "t,x,y,theta\n0,0,0,0\n1,1,0,0\n2,2,0,0\n");
  write_into(folder, "model.yaml", "wheelwright_model: 1\n");
  const auto understood = import::understand(
      {{folder},
       std::nullopt,
       import::GivenMapping("", {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"})});
  if (!understood) FAIL(understood.error());
  CHECK_FALSE(understood->mapping.reference);
  auto conversion = import::to_runs(*understood);
  check_same({*understood, std::move(conversion)}, drive);
}

TEST_CASE("A folder without a table in it, and one with a table too many, are refused by name") {
  const auto folder = temporary_folder() / "wheelwright_folder_of_notes";
  std::filesystem::create_directories(folder);
  write_into(folder, "notes.txt", "floor: parquet, new battery\n");
  const auto refusal = [&folder] {
    const auto understood = import::understand({{folder}, std::nullopt, {}});
    REQUIRE_FALSE(understood);
    return understood.error();
  };
  CHECK_THAT(refusal(), ContainsSubstring("no file in it is a log"));
  for (int k = 0; k < 40; ++k) write_into(folder, "part" + std::to_string(k) + ".csv", "t,left,right\n");
  CHECK_THAT(refusal(), ContainsSubstring("41 text files; name those of one robot"));
}

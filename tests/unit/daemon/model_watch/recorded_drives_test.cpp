// Which of the drives that a robot has recorded the watch over its model looks at.
#include "daemon/model_watch/recorded_drives.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fs = std::filesystem;
using namespace wheelwright::daemon;

namespace {

void record(const fs::path& folder, const std::string& robot, std::size_t bytes) {
  fs::create_directories(folder);
  std::ofstream(folder / "drive_log.csv") << "# wheelwright_drive_log: 1\n# robot: " << robot << "\nt\n"
                                          << std::string(bytes, '1') << "\n";
}

struct Runs {
  wheelwright::test::TemporaryFolder folder{"runs"};
  DriveChoice choice;

  Runs() {
    choice.robot = "rosie";
    choice.min_bytes = 1000;
  }
  std::vector<std::string> chosen(const std::string& newest = "2026-11-26T09-00-00Z") const {
    std::vector<std::string> names;
    for (const fs::path& drive : recorded_drives(folder.path(), folder.path() / newest, choice))
      names.push_back(drive.parent_path().filename().string());
    return names;
  }
};

}  // namespace

TEST_CASE("Drives are taken in the order in which they were recorded, the newest of them") {
  Runs runs;
  for (const char* time : {"2026-11-26T09-00-00Z", "2026-11-26T08-00-00Z", "2026-11-26T07-00-00Z"})
    record(runs.folder.path() / time, "rosie", 2000);
  runs.choice.at_most = 2;
  CHECK(runs.chosen() == std::vector<std::string>{"2026-11-26T08-00-00Z", "2026-11-26T09-00-00Z"});
}

TEST_CASE("Drives before the model was made are left out, but the run that has just ended is not") {
  Runs runs;
  record(runs.folder.path() / "2026-11-26T07-00-00Z", "rosie", 2000);
  record(runs.folder.path() / "2026-11-26T08-00-00Z", "rosie", 2000);
  runs.choice.not_before = "2026-11-26T08:30:00Z";
  CHECK(runs.chosen("2026-11-26T08-00-00Z") == std::vector<std::string>{"2026-11-26T08-00-00Z"});
}

TEST_CASE("Short drives, drives of another robot and other folders are left out") {
  Runs runs;
  record(runs.folder.path() / "2026-11-26T07-00-00Z", "rosie", 10);
  record(runs.folder.path() / "2026-11-26T08-00-00Z", "robby", 2000);
  record(runs.folder.path() / "notes", "rosie", 2000);
  fs::create_directories(runs.folder.path() / "2026-11-26T06-00-00Z");
  CHECK(runs.chosen().empty());
  CHECK(recorded_drives("/nowhere", "/nowhere/x", runs.choice).empty());
}

TEST_CASE("No more is taken than a search can hold") {
  Runs runs;
  for (const char* time : {"2026-11-26T07-00-00Z", "2026-11-26T08-00-00Z", "2026-11-26T09-00-00Z"})
    record(runs.folder.path() / time, "rosie", 2000);
  runs.choice.max_bytes = 5000;
  CHECK(runs.chosen().size() == 2);
}

TEST_CASE("The name of a run's folder says when it began") {
  CHECK(run_time("runs/2026-11-26T05-32-04Z") == "2026-11-26T05:32:04Z");
  CHECK(run_time("runs/2026-11-26T05-32-04Z_2") == "2026-11-26T05:32:04Z");
  CHECK(run_time("runs/holiday").empty());
}

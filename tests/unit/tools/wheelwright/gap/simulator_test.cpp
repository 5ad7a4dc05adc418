// A simulator of somebody else's, run by `wheelwright gap`.
#include "tools/wheelwright/gap/simulator.hpp"

#include <fstream>
#include <sstream>

#include "config/load/drive_log_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/plant_log.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/common/commands.hpp"

using namespace wheelwright;
using namespace wheelwright::tools;
namespace fs = std::filesystem;

namespace {

std::vector<SimulatorRun> run(const Simulator& simulator, const std::vector<DriveLog>& runs,
                              const fs::path& folder) {
  return run_simulator(simulator, runs, folder, [](std::size_t) {});
}

std::string refusal(const Simulator& simulator, const fs::path& folder) {
  try {
    check_simulator(simulator);
    run(simulator, {test::plant_run(1, 50)}, folder);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("A simulator gets the commands of each run and nothing that was measured") {
  const fs::path folder = test::temporary_folder() / "a simulator's folder";
  const std::vector<DriveLog> runs{test::plant_run(1, 50), test::plant_run(2, 60)};
  const auto written = run({"cp {commands} {out}"}, runs, folder);
  REQUIRE(written.size() == 2);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const DriveLog commands = config::load_drive_log(written[i].out);
    REQUIRE(commands.samples.size() == runs[i].samples.size());
    CHECK(commands.wheel_base_m == runs[i].wheel_base_m);
    CHECK_FALSE(commands.has_ticks());
    CHECK(commands.samples.front().t_s == 0.0);
    CHECK(std::abs(commands.samples[40].command_m_s.left - runs[i].samples[40].command_m_s.left) < 1e-6);
    CHECK_FALSE(commands.samples[40].reference_x_m);
  }
}

TEST_CASE("A command that does not name both files is refused before anything runs") {
  const fs::path folder = test::temporary_folder() / "never_made";
  CHECK_THAT(refusal({"my_simulator {commands}"}, folder), ContainsSubstring("has no {out}"));
  CHECK_THAT(refusal({"my_simulator {out}"}, folder), ContainsSubstring("has no {commands}"));
  CHECK_FALSE(fs::exists(folder));
}

TEST_CASE("A simulator that fails, writes nothing or takes too long is told with its last line") {
  const fs::path folder = test::temporary_folder() / "failing";
  CHECK_THAT(refusal({"echo begin; echo no such world >&2; exit 3; : {commands} {out}"}, folder),
             ContainsSubstring("it ended with status 3; its last line: 'no such world'"));
  CHECK_THAT(refusal({"echo done; : {commands} {out}"}, folder), ContainsSubstring("it wrote no "));
  CHECK_THAT(refusal({.command = "echo diverged; sleep 60; : {commands} {out}", .limit_s = 1.0}, folder),
             ContainsSubstring("it took longer than 1 s and was ended; its last line: 'diverged'"));
}

TEST_CASE("What a simulator starts ends with its time") {
  const fs::path folder = test::temporary_folder() / "children";
  const fs::path late = test::temporary_folder() / "late";
  refusal(
      {.command = "(sleep 2; touch '" + late.string() + "') & sleep 60; : {commands} {out}", .limit_s = 1.0},
      folder);
  ::usleep(2'500'000);
  CHECK_FALSE(fs::exists(late));
}

TEST_CASE("A file that no simulator wrote is not lost, nor one of the runs themselves") {
  const fs::path folder = test::temporary_folder() / "taken";
  fs::create_directories(folder);
  std::ofstream(folder / "run1.csv") << "mine\n";
  CHECK_THAT(refusal({"cp {commands} {out}"}, folder),
             ContainsSubstring("run1.csv: is no file of an earlier"));
  CHECK(fs::file_size(folder / "run1.csv") == 5);
  DriveLog own = test::plant_run(1, 50);
  own.name = (test::temporary_folder() / "own" / "run1.csv").string();
  fs::create_directories(fs::path(own.name).parent_path());
  config::save_drive_log(own, own.name);
  config::save_drive_log(own, fs::path(own.name).parent_path() / "run1_commands.csv");
  CHECK_THROWS_AS(run({"cp {commands} {out}"}, {own}, fs::path(own.name).parent_path()), UsageError);
  CHECK(config::load_drive_log(own.name).has_ticks());
}

TEST_CASE("What a simulator wrote in an earlier run is not taken for what it wrote now") {
  const fs::path folder = test::temporary_folder() / "twice";
  run({"cp {commands} {out}"}, {test::plant_run(1, 50)}, folder);
  CHECK_THAT(refusal({": {commands} {out}"}, folder), ContainsSubstring("it wrote no "));
}

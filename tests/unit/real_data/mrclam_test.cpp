// The command line over the real runs of MRCLAM, where they are.
#include <sstream>

#include "config/load/drive_log_file.hpp"
#include "model/log/command_timeline.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mrclam_logs.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/common/command_line.hpp"

using namespace wheelwright;

namespace {

struct Outcome {
  tools::ExitStatus status;
  std::string out;
  std::string err;
};

Outcome import_mrclam(const std::filesystem::path& odometry, const std::filesystem::path& truth,
                      const std::filesystem::path& output, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"import",       "mrclam", odometry.string(),
                                     truth.string(), "-o",     output.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  std::ostringstream out;
  std::ostringstream err;
  const auto status = tools::run_command_line(arguments, {out, err});
  return {status, out.str(), err.str()};
}

}  // namespace

TEST_CASE("A run of MRCLAM becomes a drive log that holds what its files hold") {
  const auto folder = test::mrclam_folder();
  if (!folder) return;
  const auto path = test::temporary_folder() / "mrclam4.csv";
  const auto outcome =
      import_mrclam(*folder / "Robot4_Odometry.dat", *folder / "Robot4_Groundtruth.dat", path);
  INFO(outcome.err);
  REQUIRE(outcome.status == tools::ExitStatus::done);
  CHECK_THAT(outcome.out, ContainsSubstring("52906 commands"));  // 52916 rows, of which 10 are superseded
  CHECK_THAT(outcome.out, ContainsSubstring("10 commands at whose very time"));
  const DriveLog log = config::load_drive_log(path);
  CHECK(log.wheel_base_m == 0.258);
  CHECK_FALSE(log.has_ticks());
  CHECK_THAT(log.samples.back().t_s, WithinAbs(884.0, 0.1));
  // Summed from the odometry file by other means: each forward speed times the time to the next row.
  const auto commanded_m = CommandTimeline(log).distance_m(log.samples.back().t_s);
  CHECK_THAT(0.5 * (commanded_m.left + commanded_m.right), WithinAbs(43.1348, 0.001));
}

TEST_CASE("MRCLAM files in the wrong order are refused in one line, and nothing is written") {
  const auto folder = test::mrclam_folder();
  if (!folder) return;
  const auto path = test::temporary_folder() / "mrclam_swapped.csv";
  const auto outcome =
      import_mrclam(*folder / "Robot1_Groundtruth.dat", *folder / "Robot1_Odometry.dat", path);
  CHECK(outcome.status == tools::ExitStatus::bad_input);
  CHECK_THAT(outcome.err, ContainsSubstring("Robot1_Groundtruth.dat:5: has 4 fields, but must have 3"));
  CHECK_FALSE(std::filesystem::exists(path));
  CHECK(import_mrclam(*folder / "Robot1_Odometry.dat", *folder / "Robot1_Groundtruth.dat", path,
                      {"--wheel-base", "0"})
            .status == tools::ExitStatus::bad_input);
}

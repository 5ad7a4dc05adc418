#include "config/load/mrclam_files.hpp"

#include "config/load/drive_log_file.hpp"
#include "model/log/command_timeline.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

const std::string odometry =
    "# Time [s]    forward velocity [m/s]    angular velocity[rad/s]\n"
    "1248444187.156 \t  0.100 \t 0.000\n"
    "1248444187.186 \t  0.100 \t 1.000\n"
    "1248444187.216 \t  0.000 \t 0.500\n"
    "1248444187.216 \t  0.050 \t 0.000\r\n"
    "1248444188.216 \t  0.000 \t 0.000\n";
const std::string ground_truth =
    "# Time [s]    x [m]    y [m]    orientation [rad]\n"
    "1248444187.100 \t 1.0 \t 2.0 \t 3.0\n"
    "1248444187.160 \t 1.1 \t 2.1 \t 3.1\n"
    "1248444187.186 \t 1.2 \t 2.2 \t -3.1\n"
    "1248444188.500 \t 1.3 \t 2.3 \t -3.0\n";

config::MrclamRun join(const std::string& commands, const std::string& poses) {
  return config::parse_mrclam_run({"odometry.dat", commands}, {"truth.dat", poses});
}

std::string refusal(const std::string& commands, const std::string& poses) {
  try {
    join(commands, poses);
  } catch (const config::LogError& error) {
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace

TEST_CASE("Commands and poses of MRCLAM are joined with each at its own time") {
  const auto run = join(odometry, ground_truth);
  const auto& rows = run.log.samples;
  REQUIRE(rows.size() == 5);  // four times of commands, one of which is also of a pose, and one of a pose
  CHECK(rows[0].t_s == 0.0);
  CHECK_FALSE(rows[0].reference_x_m);
  CHECK_THAT(rows[1].t_s, WithinAbs(0.004, 1e-9));
  CHECK(rows[1].reference_x_m == 1.1);
  CHECK(rows[1].command_m_s.left == 0.1);  // still in force
  CHECK_THAT(rows[2].t_s, WithinAbs(0.030, 1e-9));
  CHECK(rows[2].reference_theta_rad == -3.1);
  CHECK_THAT(rows[2].command_m_s.left, WithinAbs(0.1 - 0.129, 1e-12));
  CHECK_THAT(rows[2].command_m_s.right, WithinAbs(0.1 + 0.129, 1e-12));
  CHECK(run.references_before == 1);
  CHECK(run.references_after == 1);
}

TEST_CASE("Of two commands at the same time the later one holds, and the integral is exact") {
  const auto run = join(odometry, ground_truth);
  CHECK(run.superseded == 1);
  CHECK(run.log.samples[3].command_m_s.left == 0.05);
  const CommandTimeline timeline(run.log);
  const auto travelled = timeline.distance_m(1.06);
  CHECK_THAT(0.5 * (travelled.left + travelled.right), WithinAbs(0.1 * 0.06 + 0.05 * 1.0, 1e-9));
}

TEST_CASE("A file that is no MRCLAM file is refused with its line and what would be right") {
  CHECK_THAT(refusal("1 0.1\n", ground_truth),
             ContainsSubstring("odometry.dat:1: has 2 fields, but must have 3"));
  CHECK_THAT(refusal("# a\n1 0.1 x\n", ground_truth),
             ContainsSubstring("odometry.dat:2: angular velocity [rad/s] is 'x', but must be a number"));
  CHECK_THAT(refusal("1 0.1 nan\n", ground_truth), ContainsSubstring("'nan'"));
  CHECK_THAT(refusal("1 8.224 0\n", ground_truth),
             ContainsSubstring("'8.224', but must be a number of at most 5"));
  CHECK_THAT(refusal("2 0 0\n1 0 0\n", ground_truth),
             ContainsSubstring("odometry.dat:2: time goes from 2.000 to 1.000 s, but must rise"));
  CHECK_THAT(refusal(odometry, "1 0 0 0\n1 0 0 0\n"), ContainsSubstring("truth.dat:2: time goes"));
  CHECK_THAT(refusal(odometry, odometry), ContainsSubstring("has 3 fields, but must have 4"));
  CHECK_THAT(refusal("", ground_truth), ContainsSubstring("odometry.dat: holds no rows"));
  CHECK_THAT(refusal(odometry, "5 0 0 0\n"),
             ContainsSubstring("no pose lies within the time of odometry.dat"));
}

#include "daemon/telemetry/truth_trail.hpp"

#include <cmath>
#include <fstream>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using namespace wheelwright::daemon::telemetry;

namespace {

constexpr std::uint64_t second_ns = 1'000'000'000;
constexpr auto head =
    "# wheelwright_truth: 1\n# period_s: 0.5\n# started_unix_ms: "
    "100000\nt,x,y,theta,speed_left,speed_right\n";

// A file as the simulated robot writes it, piece by piece.
class TruthFile {
 public:
  TruthFile() { std::filesystem::remove(path()); }
  static std::filesystem::path path() { return test::temporary_folder() / "wheelwright_truth_test.csv"; }
  static void add(const std::string& text) { std::ofstream(path(), std::ios::app) << text; }
  static void replace(const std::string& text) { std::ofstream(path(), std::ios::trunc) << text; }
};

}  // namespace

TEST_CASE("Truth is seen from where the robot was at the start, and from then on") {
  const TruthFile file;
  TruthTrail trail(TruthFile::path());
  TruthFile::add(std::string(head) +
                 "0.0,1,1,0,0,0\n0.5,2,3,1.5707963267948966,0,0\n1.0,2,4,1.5707963267948966,0,0\n");
  CHECK(trail.read().empty());
  trail.start_at(100 * second_ns + second_ns / 4);
  const auto poses = trail.read();
  REQUIRE(poses.size() == 2);
  CHECK(poses[0].time_ns == 100 * second_ns + second_ns / 2);
  CHECK_THAT(poses[0].pose.x_m, WithinAbs(0.0, 1e-12));
  CHECK_THAT(poses[1].pose.x_m, WithinAbs(1.0, 1e-12));
  CHECK_THAT(poses[1].pose.y_m, WithinAbs(0.0, 1e-12));
  CHECK(trail.read().empty());
}

TEST_CASE("A line of the truth file that is still on its way is read once it is whole") {
  const TruthFile file;
  TruthTrail trail(TruthFile::path());
  trail.start_at(0);
  CHECK(trail.read().empty());
  TruthFile::add(std::string(head) + "0.0,0,0,0,0,0\n0.5,1.2");
  CHECK(trail.read().size() == 1);
  TruthFile::add("5,0,0,0,0\n");
  const auto poses = trail.read();
  REQUIRE(poses.size() == 1);
  CHECK(poses[0].pose.x_m == 1.25);
}

TEST_CASE("A truth file that begins again is another robot's") {
  const TruthFile file;
  TruthTrail trail(TruthFile::path());
  trail.start_at(0);
  TruthFile::add(std::string(head) + "0.0,0,0,0,0,0\n0.5,1,0,0,0,0\n");
  CHECK(trail.read().size() == 2);
  TruthFile::replace(std::string(head) + "0.0,5,0,0,0,0\n");
  trail.start_at(0);
  const auto poses = trail.read();
  REQUIRE(poses.size() == 1);
  CHECK(poses[0].pose.x_m == 0.0);
}

TEST_CASE("What is no truth file shows nothing") {
  const TruthFile file;
  TruthTrail trail(TruthFile::path());
  trail.start_at(0);
  TruthFile::add("t,x,y,theta\n1,2,3,4\n\n\xff\xff,1e999,nan\n");
  CHECK(trail.read().empty());
  TruthTrail missing("/nowhere/at/all");
  missing.start_at(0);
  CHECK(missing.read().empty());
}

TEST_CASE("A line longer than any of the truth is left out, and the poses behind it are read") {
  const TruthFile file;
  TruthTrail trail(TruthFile::path());
  trail.start_at(100 * second_ns);
  TruthFile::add(head + std::string(300'000, 'x') + "\n0.0,1,1,0,0,0\n0.5,2,1,0,0,0\n");
  CHECK(trail.read().size() == 2);
}

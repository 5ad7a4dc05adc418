// The disk under the logs is full: the robot stays under control, and the loss is told.
#include <sys/mount.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

// A disk of a few pages, mounted on a folder.
class TinyDisk {
 public:
  explicit TinyDisk(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_);
    mounted_ = ::mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=24k") == 0;
  }
  TinyDisk(const TinyDisk&) = delete;
  TinyDisk& operator=(const TinyDisk&) = delete;
  ~TinyDisk() {
    if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
  }

  bool mounted() const { return mounted_; }

 private:
  std::filesystem::path folder_;
  bool mounted_ = false;
};

}  // namespace

TEST_CASE("On a full disk the route is driven to its end, the file is named, and the exit status is 1") {
  Bench bench;
  const TinyDisk disk(bench.folder() / "runs");
  if (!disk.mounted()) return skip("only root can mount a disk that is small enough to fill");
  const auto robot = bench.start_robot("perfect");
  const auto daemon = bench.start_daemon(bench.configure({}));
  CHECK(daemon->wait(20s) == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: finished"));
  CHECK_THAT(daemon->out(), ContainsSubstring("drive_log.csv: cannot be written: No space left on device"));
  CHECK_THAT(daemon->err(), ContainsSubstring("drive_log.csv: cannot be written: No space left on device"));
  std::ifstream log(bench.runs().back() / "drive_log.csv");
  const std::string text{std::istreambuf_iterator<char>(log), {}};
  REQUIRE(text.size() > 1000);
  CHECK(text.back() == '\n');
  robot->end();
  const Table truth = bench.truth();
  CHECK_THAT(truth.number(truth.rows() - 1, "x"), WithinAbs(0.25, 0.03));
}

TEST_CASE("A hazard on a full disk stops the robot all the same") {
  Bench bench;
  const TinyDisk disk(bench.folder() / "runs");
  if (!disk.mounted()) return skip("only root can mount a disk that is small enough to fill");
  bench.write("wall.yaml", "walls_m: [[0.6, -1, 0.6, 1]]\n");
  const auto robot = bench.start_robot("perfect", "room: wall.yaml\n");
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[3, 0]]"}));
  CHECK(daemon->wait(20s) == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: stopped, bump"));
  CHECK_THAT(daemon->err(), ContainsSubstring("flight_recorder.csv"));
}

// A run's folder explains itself: the brain over its drive log writes the same pose log.
#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

int replay_status(const std::filesystem::path& run, std::string& out) {
  ChildProcess replay({WHEELWRIGHT, "replay", (run / "drive_log.csv").string()}, run / "replay");
  const int status = replay.wait(30s);
  out = replay.out() + replay.err();
  return status;
}

}  // namespace

TEST_CASE("Replay of a route's drive log gives the pose log to the byte, whatever steers") {
  for (const std::string source : {"fir", "hybrid", "odometry"}) {
    INFO(source);
    Bench bench;
    const auto robot = bench.start_robot("default");
    const auto daemon = bench.start_daemon(bench.configure({.run = "pose_source: " + source}));
    REQUIRE(daemon->wait(30s) == 0);
    std::string out;
    CHECK(replay_status(bench.runs().back(), out) == 0);
    CHECK_THAT(out, ContainsSubstring("the same to the byte"));
  }
}

TEST_CASE("Replay of a run that calibrated fits the same model again") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(
      bench.configure({.calibration = "when: always, encoder: {turns: 1.8}, response: {repetitions: 3}",
                       .has_model = false}));
  REQUIRE(daemon->wait(90s) == 0);
  std::string out;
  CHECK(replay_status(bench.runs().back(), out) == 0);
  CHECK_THAT(out, ContainsSubstring("the same to the byte"));
}

TEST_CASE("Replay with another route than was driven says from which tick on it differs") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure({}));
  REQUIRE(daemon->wait(30s) == 0);
  const auto run = bench.runs().back();
  ChildProcess replay({WHEELWRIGHT, "replay", (run / "drive_log.csv").string(), "--config",
                       bench.configure({.route = "[[0, 0.3]]"}).string()},
                      run / "replay");
  CHECK(replay.wait(30s) == 1);
  CHECK_THAT(replay.err(), ContainsSubstring("commands something else"));
}

// A run without hazards: what every other test here is to be compared with.
#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

TEST_CASE("The daemon drives a route on the simulated robot, logs it whole, and exits with 0") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto daemon = bench.start_daemon(bench.configure({}));
  CHECK(daemon->wait(20s) == 0);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: finished"));
  const Replies replies = replies_of(daemon->out());
  CHECK(20 * replies.sound > 19 * replies.asked);

  const Table log = bench.drive_log();
  REQUIRE(log.rows() > 50);
  CHECK(bench.pose_log().rows() == log.rows());
  for (std::size_t row = 0; row < log.rows(); ++row) {
    CHECK(log.number(row, "tick") == static_cast<double>(row));
  }
  robot->end();
  const Table truth = bench.truth();
  CHECK_THAT(truth.number(truth.rows() - 1, "x"), WithinAbs(0.25, 0.03));
  CHECK(log.word(log.rows() - 1, "activity") == "finished");
}

// A run without hazards: what every other test here is to be compared with.
#include <chrono>
#include <thread>

#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

// Folders of runs are named by the second.
void wait_for_the_begin_of_a_second() {
  const auto now = std::chrono::system_clock::now();
  std::this_thread::sleep_until(std::chrono::floor<std::chrono::seconds>(now) + 1s);
}

// The ticks of a log rise from 0. Returns how many it left out.
int check_ticks_rise(const Table& log) {
  CHECK(log.number(0, "tick") == 0.0);
  for (std::size_t row = 1; row < log.rows(); ++row)
    CHECK(log.number(row, "tick") > log.number(row - 1, "tick"));
  return static_cast<int>(log.number(log.rows() - 1, "tick")) + 1 - static_cast<int>(log.rows());
}

}  // namespace

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
  CHECK(check_ticks_rise(log) <= skipped_periods_of(daemon->out()));
  robot->end();
  const Table truth = bench.truth();
  CHECK_THAT(truth.number(truth.rows() - 1, "x"), WithinAbs(0.25, 0.03));
  CHECK(log.word(log.rows() - 1, "activity") == "finished");
}

TEST_CASE(
    "Daemons of two robots that start in the same second with one log folder have a run's folder each") {
  Bench first, second;
  std::filesystem::create_directory(first.folder() / "runs");
  std::filesystem::create_directory_symlink(first.folder() / "runs", second.folder() / "runs");
  const auto one_robot = first.start_robot("perfect");
  const auto other_robot = second.start_robot("perfect");
  wait_for_the_begin_of_a_second();
  const auto one = first.start_daemon(first.configure({}));
  const auto other = second.start_daemon(second.configure({}));
  CHECK(one->wait(20s) == 0);
  CHECK(other->wait(20s) == 0);
  const auto runs = first.runs();
  REQUIRE(runs.size() == 2);
  int left_out = 0;
  for (const auto& run : runs) {
    const Table log = Table::load(run / "drive_log.csv");
    REQUIRE(log.rows() > 50);
    left_out += check_ticks_rise(log);
    CHECK(log.word(log.rows() - 1, "activity") == "finished");
  }
  CHECK(left_out <= skipped_periods_of(one->out()) + skipped_periods_of(other->out()));
  // By the second: the later one has a number behind its name.
  CHECK(runs.back().filename().string() == runs.front().filename().string() + "_2");
}

// The daemon is told to end, or to stop.
#include <csignal>
#include <optional>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/loopback/bench/wheel_rest.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

constexpr auto long_way = "[[3, 0]]";

}  // namespace

TEST_CASE(
    "After SIGTERM the order to stand is out within 40 ms, and from 0.15 m/s the robot stands in 250 ms") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  DaemonSetup setup{.device = "tapped", .route = long_way, .speed_m_s = 0.15};
  const auto daemon = bench.start_daemon(bench.configure(setup));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(1s);
  const double at_ms = unix_ms_now();
  const auto at = LineTap::Clock::now();
  daemon->signal(SIGTERM);
  CHECK(daemon->wait(5s) == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: stopped, ended by a signal"));
  const auto orders = tap.drive_orders();
  REQUIRE(orders.first_standing);
  std::this_thread::sleep_for(500ms);
  robot->end();
  const double order_ms = std::chrono::duration<double, std::milli>(*orders.first_standing - at).count();
  const double stands_ms = ms_to_rest(bench.truth(), at_ms);
  CAPTURE(order_ms, stands_ms);
  CHECK(order_ms < 40.0);
  CHECK(stands_ms < 250.0);
  const Table log = bench.drive_log();
  CHECK(log.number(log.rows() - 1, "cmd_left") == 0.0);
  CHECK(bench.pose_log().rows() == log.rows());
}

TEST_CASE("SIGUSR2 stops the robot but not the daemon, and SIGUSR1 starts the mission again") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto daemon = bench.start_daemon(bench.configure({.run = "at_end: stay"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(500ms);
  daemon->signal(SIGUSR2);
  REQUIRE(daemon->says("requested", 2s));
  std::this_thread::sleep_for(600ms);
  CHECK(daemon->wait(0ms) == ChildProcess::still_running);
  CHECK_FALSE(daemon->says("finished", 0ms));
  daemon->signal(SIGUSR1);
  CHECK(daemon->says("finished", 10s));
  CHECK(daemon->end() == 0);
}

TEST_CASE("With run.arm by_signal nothing moves before SIGUSR1") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto config = bench.configure({.device = "tapped", .run = "arm: by_signal", .route = "[[0.15, 0]]"});
  const auto daemon = bench.start_daemon(config);
  REQUIRE(daemon->says("the robot answers", 5s));
  std::this_thread::sleep_for(600ms);
  CHECK_FALSE(tap.drive_orders().last_moving);
  daemon->signal(SIGUSR1);
  CHECK(daemon->wait(10s) == 0);
  CHECK(tap.drive_orders().last_moving);
}

TEST_CASE("SIGUSR1 in mid-drive changes nothing: the robot drives on to the end") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[0.3, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(800ms);
  daemon->signal(SIGUSR1);
  CHECK(daemon->says("armed already: the robot drives on", 2s));
  CHECK(daemon->wait(15s) == 0);
  const Table log = bench.drive_log();
  std::optional<std::size_t> last_moving;
  int pauses = 0;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (log.number(row, "cmd_left") == 0.0) continue;
    pauses += last_moving && row - *last_moving > 1 ? 1 : 0;
    last_moving = row;
  }
  CHECK(last_moving);
  CHECK(pauses == 0);
}

TEST_CASE("SIGTERM right behind SIGUSR1 is obeyed: no order to drive goes out any more") {
  const auto between = GENERATE(0ms, 18ms, 40ms);
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const bool drives = GENERATE(false, true);
  const std::string arm = drives ? "at_start" : "by_signal";
  const auto daemon =
      bench.start_daemon(bench.configure({.device = "tapped", .run = "arm: " + arm, .route = long_way}));
  REQUIRE(daemon->says(drives ? "route: driving" : "the robot answers", 10s));
  std::this_thread::sleep_for(800ms);
  daemon->signal(SIGUSR1);
  std::this_thread::sleep_for(between);
  const auto at = LineTap::Clock::now();
  daemon->signal(SIGTERM);
  CHECK(daemon->wait(5s) == 1);
  const auto moving = tap.drive_orders().last_moving;
  CAPTURE(drives, between.count());
  if (moving) CHECK(*moving - at < 40ms);
  if (drives) CHECK(moving);
}

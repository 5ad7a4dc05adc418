// Whatever happens to the daemon, the wheels come to rest. Each case prints how long that took.
#include <cmath>
#include <csignal>
#include <fstream>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/held_thread.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/loopback/bench/wheel_rest.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

constexpr auto long_way = "[[3, 0]]";
constexpr double longest_ms = 300.0;
// Without real-time scheduling the guardian waits for as long as the robot may drive blind, 250 ms by
// default.
constexpr double longest_without_real_time_ms = 550.0;

void check_rest(const std::string& after, double ms, double limit_ms = longest_ms) {
  WARN("wheels at rest " << std::lround(ms) << " ms after " << after);
  CHECK(ms < limit_ms);
}

// Of a loop that stands still, by what this system granted the daemon.
double stall_limit_ms(const ChildProcess& daemon) {
  return daemon.says("SCHED_FIFO", 0ms) ? longest_ms : longest_without_real_time_ms;
}

// A robot that drives straight on at 0.2 m/s.
struct Drive {
  explicit Drive(const DaemonSetup& setup = {.route = long_way})
      : robot(bench.start_robot("default")), daemon(bench.start_daemon(bench.configure(setup))) {
    REQUIRE(daemon->says("route: driving", 10s));
    std::this_thread::sleep_for(1500ms);
  }

  double signal(int number) const {
    const double at_ms = unix_ms_now();
    daemon->signal(number);
    return at_ms;
  }

  Bench bench;
  std::unique_ptr<ChildProcess> robot;
  std::unique_ptr<ChildProcess> daemon;
};

}  // namespace

TEST_CASE("After SIGKILL and after a crash the wheels stand within 300 ms") {
  for (const int number : {SIGKILL, SIGSEGV}) {
    Drive drive;
    const double at_ms = drive.signal(number);
    CHECK(drive.daemon->wait(5s) == -number);
    CHECK(drive.daemon->says("guardian: the daemon is gone", 1s));
    std::this_thread::sleep_for(1s);
    drive.robot->end();
    const Table truth = drive.bench.truth();
    CHECK(speed_at(truth, at_ms) > 0.15);
    check_rest(number == SIGKILL ? "SIGKILL" : "SIGSEGV", ms_to_rest(truth, at_ms));
  }
}

TEST_CASE("A daemon that is stopped loses the wheels within 300 ms, and ends its run when it goes on") {
  Drive drive;
  const double at_ms = drive.signal(SIGSTOP);
  CHECK(drive.daemon->says("guardian: the sensor loop stands still", 1s));
  std::this_thread::sleep_for(1s);
  const double continued_ms = drive.signal(SIGCONT);
  CHECK(drive.daemon->wait(5s) == 1);
  CHECK_THAT(drive.daemon->out(), ContainsSubstring("Result: stopped, sensor loop stood still"));
  drive.robot->end();
  const Table truth = drive.bench.truth();
  check_rest("SIGSTOP", ms_to_rest(truth, at_ms, continued_ms), stall_limit_ms(*drive.daemon));
  CHECK(ms_to_rest(truth, continued_ms) < 1.0);
}

TEST_CASE("A sensor loop that hangs loses the wheels within 300 ms") {
  Drive drive;
  const double at_ms = unix_ms_now();
  const HeldThread hung(drive.daemon->pid(), "ww-loop");
  if (!hung) return skip("this system does not let a thread be held");
  CHECK(drive.daemon->says("guardian: the sensor loop stands still", 1s));
  std::this_thread::sleep_for(1s);
  drive.robot->end();
  check_rest("the loop hung", ms_to_rest(drive.bench.truth(), at_ms), stall_limit_ms(*drive.daemon));
}

TEST_CASE("A daemon whose guardian is killed stops the wheels itself and ends") {
  Drive drive;
  const auto guardian = drive.daemon->child();
  if (!guardian) return skip("this kernel does not tell the children of a process");
  const double at_ms = unix_ms_now();
  ::kill(*guardian, SIGKILL);
  CHECK(drive.daemon->wait(5s) == 1);
  CHECK_THAT(drive.daemon->out(), ContainsSubstring("the guardian process has ended"));
  drive.robot->end();
  check_rest("the guardian was killed", ms_to_rest(drive.bench.truth(), at_ms));
}

TEST_CASE("A daemon whose guardian is stopped stops the wheels itself, and ends with its guardian") {
  Drive drive;
  const auto guardian = drive.daemon->child();
  if (!guardian) return skip("this kernel does not tell the children of a process");
  ::kill(*guardian, SIGSTOP);
  CHECK(drive.daemon->wait(5s) == 1);
  CHECK_THAT(drive.daemon->out(), ContainsSubstring("the guardian process stands still"));
  CHECK(::kill(*guardian, 0) != 0);
  const double ended_ms = unix_ms_now();
  std::this_thread::sleep_for(500ms);
  drive.robot->end();
  CHECK(ms_to_rest(drive.bench.truth(), ended_ms) < 1.0);
}

TEST_CASE("A daemon with a stopped guardian obeys SIGTERM and ends") {
  Drive drive;
  const auto guardian = drive.daemon->child();
  if (!guardian) return skip("this kernel does not tell the children of a process");
  ::kill(*guardian, SIGSTOP);
  const double at_ms = drive.signal(SIGTERM);
  CHECK(drive.daemon->wait(5s) == 1);
  drive.robot->end();
  check_rest("SIGTERM, with a stopped guardian", ms_to_rest(drive.bench.truth(), at_ms));
}

TEST_CASE("A daemon whose loop hangs for good ends after SIGTERM, and leaves the wheels at rest") {
  Drive drive;
  const double at_ms = unix_ms_now();
  const HeldThread hung(drive.daemon->pid(), "ww-loop");
  if (!hung) return skip("this system does not let a thread be held");
  drive.signal(SIGTERM);
  CHECK(drive.daemon->says("the sensor loop hangs and does not end", 8s));
  drive.robot->end();
  check_rest("SIGTERM of a hung loop", ms_to_rest(drive.bench.truth(), at_ms), stall_limit_ms(*drive.daemon));
}

TEST_CASE("A run that was stopped for less than the guardian's patience goes on") {
  Drive drive({.link = "lost_after_s: 5, blind_limit_s: 1", .route = "[[0.6, 0]]"});
  drive.signal(SIGSTOP);
  std::this_thread::sleep_for(25ms);
  drive.signal(SIGCONT);
  CHECK(drive.daemon->wait(10s) == 0);
  CHECK_THAT(drive.daemon->err(), !ContainsSubstring("guardian"));
}

TEST_CASE("A run that ends in order leaves no guardian, and the guardian leaves the robot alone") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[0.15, 0]]"}));
  CHECK(daemon->wait(10s) == 0);
  CHECK_THAT(daemon->err(), !ContainsSubstring("guardian"));
  const auto again = bench.start_daemon(bench.configure({.route = "[[0.15, 0]]"}));
  CHECK(again->wait(10s) == 0);
}

TEST_CASE("The guardian follows the daemon to a cable that was pulled out and put in again") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto daemon =
      bench.start_daemon(bench.configure({.device = "tapped", .run = "at_end: stay", .route = long_way}));
  REQUIRE(daemon->says("route: driving", 10s));
  tap.pull_out();
  REQUIRE(daemon->says("link lost", 3s));
  tap.put_in();
  REQUIRE(daemon->says("is open again", 5s));
  std::this_thread::sleep_for(1s);
  daemon->signal(SIGUSR1);
  std::this_thread::sleep_for(2500ms);
  const double at_ms = unix_ms_now();
  daemon->signal(SIGKILL);
  CHECK(daemon->wait(5s) == -SIGKILL);
  std::this_thread::sleep_for(1s);
  robot->end();
  const Table truth = bench.truth();
  CHECK(speed_at(truth, at_ms) > 0.15);
  check_rest("SIGKILL on the second cable", ms_to_rest(truth, at_ms));
}

TEST_CASE("After SIGKILL in mid-route a new daemon gets the robot at rest, and drives its own route") {
  Drive drive;
  drive.signal(SIGKILL);
  REQUIRE(drive.daemon->wait(5s) == -SIGKILL);
  const auto second = drive.bench.start_daemon(drive.bench.configure({.run = "arm: by_signal"}));
  REQUIRE(second->says("the robot answers", 5s));
  std::this_thread::sleep_for(500ms);
  const double armed_ms = unix_ms_now();
  second->signal(SIGUSR1);
  CHECK(second->wait(15s) == 0);
  drive.robot->end();
  const Table truth = drive.bench.truth();
  CHECK(std::abs(speed_at(truth, armed_ms)) < 0.001);
  CHECK(drive.bench.runs().size() == 2);
  CHECK(Table::load(drive.bench.runs().front() / "drive_log.csv").rows() > 0);
}

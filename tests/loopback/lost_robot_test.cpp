// The robot or its cable goes away in mid-run and comes back.
#include <cmath>
#include <csignal>
#include <filesystem>

#include "config/load/drive_log_file.hpp"
#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

// How often `text` stands in `where`.
int times_said(const std::string& where, const std::string& text) {
  int times = 0;
  for (std::size_t at = 0; (at = where.find(text, at)) != std::string::npos; at += text.size()) ++times;
  return times;
}

bool answers_again(const ChildProcess& daemon) {
  return eventually(10s, [&] { return times_said(daemon.err(), "the robot answers") == 2; });
}

// Odometry moves from row to row no further than a robot can: at a gap it stands.
void check_odometry_has_no_jump(const Table& pose_log) {
  for (std::size_t row = 1; row < pose_log.rows(); ++row) {
    if (pose_log.number(row, "t") < pose_log.number(row - 1, "t")) continue;  // started again
    const double step_m = pose_log.number(row, "odometry_x") - pose_log.number(row - 1, "odometry_x");
    CAPTURE(pose_log.number(row, "t"));
    CHECK(std::abs(step_m) < 0.02);
  }
}

}  // namespace

TEST_CASE("A robot that is switched off and on again stands until it is armed, then drives its route") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure({.run = "at_end: stay"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(700ms);
  robot->signal(SIGUSR1);
  CHECK(daemon->says("no valid sensor reading for too long", 3s));
  CHECK(daemon->says("the robot does not answer any more", 3s));
  std::this_thread::sleep_for(300ms);
  daemon->signal(SIGUSR1);
  CHECK(daemon->says("not armed: the robot does not answer", 2s));
  robot->signal(SIGUSR1);
  REQUIRE(answers_again(*daemon));
  std::this_thread::sleep_for(700ms);
  CHECK(times_said(daemon->err(), "route: driving") == 1);
  CHECK(times_said(daemon->err(), "armed: the robot obeys") == 1);

  daemon->signal(SIGUSR1);
  CHECK(daemon->says("finished", 10s));
  CHECK(daemon->end() == 0);
  check_odometry_has_no_jump(bench.pose_log());
}

TEST_CASE("A robot that is armed again after its run drives another, with a folder of its own") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure({.run = "at_end: stay", .route = "[[0.3, 0]]"}));
  REQUIRE(daemon->says("finished", 15s));
  std::this_thread::sleep_for(300ms);
  daemon->signal(SIGUSR1);
  REQUIRE(eventually(5s, [&] { return bench.runs().size() == 2; }));
  REQUIRE(eventually(15s, [&] { return times_said(daemon->err(), "finished") >= 2; }));
  CHECK(daemon->end() == 0);
  for (const auto& run : bench.runs()) {
    INFO(run.string());
    for (const char* name : {"config.yaml", "model.yaml", "drive_log.csv", "pose_log.csv"})
      CHECK(std::filesystem::exists(run / name));
    const wheelwright::DriveLog log = wheelwright::config::load_drive_log(run / "drive_log.csv");
    CHECK(log.samples.front().t_s == 0.0);
    CHECK(log.samples.size() > 100);
  }
}

TEST_CASE("A stop while the next run begins takes its arming back, and no log holds two runs") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure({.run = "at_end: stay", .route = "[[3, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  daemon->signal(SIGUSR2);
  REQUIRE(daemon->says("stopped", 5s));
  std::this_thread::sleep_for(1200ms);
  for (const int signal : {SIGUSR1, SIGUSR2, SIGUSR1}) {
    daemon->signal(signal);
    std::this_thread::sleep_for(120ms);
  }
  REQUIRE(eventually(10s, [&] { return times_said(daemon->err(), "route: driving") == 2; }));
  std::this_thread::sleep_for(500ms);
  CHECK(daemon->end() == 1);
  for (const auto& run : bench.runs()) {
    INFO(run.string());
    const Table log = Table::load(run / "drive_log.csv");
    for (std::size_t row = 1; row < log.rows(); ++row)
      REQUIRE(log.number(row, "t") > log.number(row - 1, "t"));
  }
}

TEST_CASE("A cable that is pulled out costs the run, and put in again, the robot is stopped, not followed") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto daemon =
      bench.start_daemon(bench.configure({.device = "tapped", .run = "at_end: stay", .route = "[[3, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(700ms);
  tap.pull_out();
  CHECK(daemon->says("link lost", 3s));
  std::this_thread::sleep_for(1s);  // the robot drives on: its protocol knows no time-out
  tap.put_in();
  REQUIRE(answers_again(*daemon));
  std::this_thread::sleep_for(1s);
  CHECK_FALSE(tap.drive_orders().last_moving > tap.drive_orders().first_standing);
  CHECK(times_said(daemon->err(), "route: driving") == 1);
  CHECK(daemon->end() == 1);
  robot->end();
  const Table truth = bench.truth();
  CHECK(std::abs(truth.number(truth.rows() - 1, "speed_left")) < 0.001);
  check_odometry_has_no_jump(bench.pose_log());
}

TEST_CASE("Without run.at_end 'stay' a robot that falls silent ends the run with 1") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[3, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(300ms);
  robot->signal(SIGUSR1);
  REQUIRE(daemon->says("the robot may still drive: lift it or plug it in again", 5s));
  CHECK(daemon->end() == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: stopped, no valid sensor reading for too long"));
  CHECK_THAT(daemon->out(), ContainsSubstring("it could not be told to stand: lift it"));
  CHECK(Table::load(bench.runs().back() / "flight_recorder.csv").rows() > 20);
}

TEST_CASE(
    "Without run.at_end 'stay' a robot that is plugged in again is told to stand before the daemon ends") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto daemon = bench.start_daemon(bench.configure({.device = "tapped", .route = "[[3, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(700ms);
  tap.pull_out();
  REQUIRE(daemon->says("the robot may still drive", 5s));
  std::this_thread::sleep_for(1s);
  tap.put_in();
  CHECK(daemon->wait(15s) == 1);
  CHECK_THAT(daemon->err(), ContainsSubstring("the robot answers again"));
  CHECK_THAT(daemon->out(), !ContainsSubstring("could not be told to stand"));
  std::this_thread::sleep_for(500ms);
  robot->end();
  const Table truth = bench.truth();
  CHECK(std::abs(truth.number(truth.rows() - 1, "speed_left")) < 0.001);
}

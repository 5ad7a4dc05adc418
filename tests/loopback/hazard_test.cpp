// Something in the room, or the robot itself, ends the drive.
#include <cmath>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

DaemonSetup long_drive() {
  return {.route = "[[3, 0]]"};
}

// The run has ended by `reason`, with all that a person needs to see why.
void check_stopped_by(const std::string& reason, Bench& bench, ChildProcess& robot, ChildProcess& daemon) {
  CHECK(daemon.wait(15s) == 1);
  CHECK_THAT(daemon.out(), ContainsSubstring("Result: stopped, " + reason));
  CHECK_THAT(daemon.err(), ContainsSubstring(": " + reason));
  const Table log = bench.drive_log();
  REQUIRE(log.rows() > 0);
  CHECK(bench.pose_log().rows() == log.rows());
  const std::size_t last = log.rows() - 1;
  CHECK(log.word(last, "stop") == reason);
  CHECK(log.word(last, "activity") == "stopped");
  CHECK(log.number(last, "cmd_left") == 0.0);
  CHECK(log.number(last, "cmd_right") == 0.0);

  const Table recorder = Table::load(bench.runs().back() / "flight_recorder.csv");
  CHECK(recorder.metadata("stopped") == reason);
  CHECK(recorder.rows() > 20);
  CHECK(recorder.word(recorder.rows() - 1, "stop") == reason);

  std::this_thread::sleep_for(1s);  // a wheel runs out; how soon it has to stand is guardian_test's matter
  robot.end();
  const Table truth = bench.truth();
  CHECK(std::abs(truth.number(truth.rows() - 1, "speed_left")) < 0.001);
  CHECK(std::abs(truth.number(truth.rows() - 1, "speed_right")) < 0.001);
}

// Ticks from the one whose sensors show the danger to the first that is told to stand.
int ticks_to_stop(const Table& log, const std::string& column) {
  int ticks = -1;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (ticks < 0 && (log.empty(row, column) || log.number(row, column) == 0.0)) continue;
    ++ticks;
    if (log.number(row, "cmd_left") == 0.0 && log.number(row, "cmd_right") == 0.0) return ticks;
  }
  return ticks;
}

}  // namespace

TEST_CASE("A bump stops the run") {
  Bench bench;
  bench.write("wall.yaml", "walls_m: [[0.4, -1, 0.4, 1]]\n");
  const auto robot = bench.start_robot("default", "room: wall.yaml\n");
  const auto daemon = bench.start_daemon(bench.configure(long_drive()));
  check_stopped_by("bump", bench, *robot, *daemon);
  CHECK(ticks_to_stop(bench.drive_log(), "bump") <= 1);
}

TEST_CASE("A cliff stops the run before a wheel is over it") {
  Bench bench;
  bench.write("stairs.yaml", "cliffs:\n  - { x_m: 1.4, y_m: 0, size_x_m: 2, size_y_m: 2 }\n");
  const auto robot = bench.start_robot("default", "room: stairs.yaml\n");
  const auto daemon = bench.start_daemon(bench.configure(long_drive()));
  check_stopped_by("cliff", bench, *robot, *daemon);
  const Table truth = bench.truth();
  CHECK(truth.number(truth.rows() - 1, "x") < 0.4);
}

TEST_CASE("In Full mode, where the robot does not mind a cliff, the daemon stops it") {
  Bench bench;
  bench.write("stairs.yaml", "cliffs:\n  - { x_m: 1.4, y_m: 0, size_x_m: 2, size_y_m: 2 }\n");
  const auto robot = bench.start_robot("default", "room: stairs.yaml\n");
  DaemonSetup setup = long_drive();
  setup.link = "mode: full";
  const auto daemon = bench.start_daemon(bench.configure(setup));
  check_stopped_by("cliff", bench, *robot, *daemon);
  CHECK(ticks_to_stop(bench.drive_log(), "cliff") <= 1);
  const Table truth = bench.truth();
  CHECK(truth.number(truth.rows() - 1, "x") < 0.4);
}

TEST_CASE("A wheel that drops stops the run") {
  Bench bench;
  // Under the left wheel and between the cliff sensors.
  bench.write("hole.yaml", "cliffs:\n  - { x_m: 0.4, y_m: 0.1125, size_x_m: 0.1, size_y_m: 0.02 }\n");
  const auto robot = bench.start_robot("perfect", "room: hole.yaml\n");
  const auto daemon = bench.start_daemon(bench.configure(long_drive()));
  check_stopped_by("wheel drop", bench, *robot, *daemon);
}

TEST_CASE("A press on Clean, which ends Safe mode, stops the run") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  DaemonSetup setup = long_drive();
  setup.device = "tapped";
  const auto daemon = bench.start_daemon(bench.configure(setup));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(500ms);
  tap.tell_robot(std::array<std::uint8_t, 1>{135});
  check_stopped_by("robot left the driving mode", bench, *robot, *daemon);
}

TEST_CASE("A battery that sags below the limit when the motors pull stops the run") {
  Bench bench;
  const auto robot = bench.start_robot("default",
                                       "battery: { full_voltage_v: 15, empty_voltage_v: 15, "
                                       "internal_resistance_ohm: 4, voltage_noise_v: 0 }\n");
  DaemonSetup setup = long_drive();
  setup.limits = "lowest_battery_v: 14";
  const auto daemon = bench.start_daemon(bench.configure(setup));
  check_stopped_by("low battery", bench, *robot, *daemon);
}

// Every way to talk to a robot, from calibration to the end of a route.
#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

constexpr auto short_calibration =
    "when: always, encoder: {speed_m_s: 0.3, turns: 1.7, largest_relative_error: 0.02}, "
    "response: {repetitions: 3, on_s: 0.5}";

// The robot has calibrated itself, and its model took it straight ahead to within `tolerance_m`.
void check_calibrated_and_driven(Bench& bench, ChildProcess& robot, ChildProcess& daemon,
                                 double tolerance_m) {
  const int status = daemon.wait(60s);
  INFO(daemon.err() << daemon.out());
  CHECK(status == 0);
  CHECK_THAT(daemon.out(), ContainsSubstring("checkpoints visited         1 of 1"));
  CHECK_THAT(daemon.out(), ContainsSubstring("gain, left wheel"));
  robot.end();
  const Table pose_log = bench.pose_log();
  const std::size_t end = pose_log.rows() - 1;
  CHECK_THAT(pose_log.number(end, "x"), WithinAbs(0.25, 0.02));
  CHECK_THAT(pose_log.number(end, "odometry_x"), WithinAbs(0.25, tolerance_m));
  CHECK_THAT(pose_log.number(end, "odometry_y"), WithinAbs(0.0, tolerance_m));
}

}  // namespace

TEST_CASE("By the stream, whose clock is the robot's, a route is driven by odometry") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure({.link = "transport: stream, period_s: 0.015625",
                                                          .run = "pose_source: odometry",
                                                          .has_model = false,
                                                          .route = "[[0.6, 0]]"}));
  CHECK(daemon->wait(20s) == 0);
  CHECK_THAT(daemon->err(), ContainsSubstring("the robot streams every 15.6"));
  CHECK_THAT(daemon->err(), ContainsSubstring("the header byte is included"));
  CHECK_THAT(daemon->out(), ContainsSubstring(" sound, 0 corrupt"));
}

TEST_CASE("By Drive PWM, with the robot's own speed control off, a robot calibrates itself and drives") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure(
      {.link = "drive: pwm, blind_limit_s: 1, lost_after_s: 2", .calibration = short_calibration}));
  // Without speed control a stop is longer than a start, which a linear model cannot say.
  check_calibrated_and_driven(bench, *robot, *daemon, 0.06);
}

TEST_CASE("A robot with every oddity of firmware and adapter is found out, and driven") {
  const auto odd_robot =
      "encoder: { swap_sides: true }\n"
      "link:\n"
      "  checksum_excludes_header: true\n"
      "  mode_plus_one: true\n"
      "  stray_text: \"battery-voltage 14.6V charging\\r\\n\"\n"
      "  stray_text_interval_s: 3\n"
      "  usb_latency_timer_s: 0.012\n";
  Bench bench;
  const auto robot = bench.start_robot("default", odd_robot);
  const auto daemon = bench.start_daemon(
      bench.configure({.link = "transport: stream, period_s: 0.015625, blind_limit_s: 1, lost_after_s: 2",
                       .calibration = short_calibration}));
  check_calibrated_and_driven(bench, *robot, *daemon, 0.03);
  CHECK_THAT(daemon->err(), ContainsSubstring("packet 44 is the left wheel"));
  CHECK_THAT(daemon->err(), ContainsSubstring("the header byte is not included"));
}

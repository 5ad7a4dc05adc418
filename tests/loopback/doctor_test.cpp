// wheelwright doctor as a process, at the bedside of simulated robots.
#include <csignal>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

std::unique_ptr<ChildProcess> start_doctor(const Bench& bench, const std::vector<std::string>& options = {}) {
  std::vector<std::string> command{WHEELWRIGHT, "doctor", "--device", bench.device()};
  command.insert(command.end(), options.begin(), options.end());
  return std::make_unique<ChildProcess>(command, bench.folder() / "doctor");
}

}  // namespace

TEST_CASE("the doctor finds a sound robot fit to drive, and does not move it") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto doctor = start_doctor(bench);
  CHECK(doctor->wait(15s) == 0);
  CHECK_THAT(doctor->out(), ContainsSubstring("answers at 115200") && ContainsSubstring("header included") &&
                                ContainsSubstring("the 15.625 ms kind") && ContainsSubstring("Fit to drive"));
  CHECK(doctor->err().empty());
  robot->end();
  const Travel travel = travel_of(bench.truth());
  CHECK(std::abs(travel.left_m) + std::abs(travel.right_m) < 1e-4);
}

TEST_CASE("the doctor finds a robot that was switched to 19200 baud") {
  Bench bench;
  const auto robot = bench.start_robot("default", "link:\n  baud: 19200\n");
  const auto doctor = start_doctor(bench);
  CHECK(doctor->wait(15s) == 1);
  CHECK_THAT(doctor->out(), ContainsSubstring("answers at 19200, not at 115200") &&
                                ContainsSubstring("opcode 129, code 11"));
}

TEST_CASE("the doctor sees behind a bad cable, and which encoder is which") {
  Bench bench;
  const auto robot = bench.start_robot("bad_cable");
  const auto doctor = start_doctor(bench, {"--move"});
  CHECK(doctor->wait(15s) == 0);
  CHECK_THAT(doctor->out(), ContainsSubstring("header excluded") && ContainsSubstring("43 is right") &&
                                ContainsSubstring("counts from one") && ContainsSubstring("15.625 ms kind"));
}

TEST_CASE("an interrupted doctor leaves the robot at rest") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  ChildProcess doctor({WHEELWRIGHT, "doctor", "--device", bench.folder() / "tapped", "--move"},
                      bench.folder() / "doctor");
  REQUIRE(eventually(15s, [&] { return tap.drive_orders().last_moving.has_value(); }));
  std::this_thread::sleep_for(200ms);
  doctor.signal(SIGINT);
  CHECK(doctor.wait(2s) == 1);
  CHECK(doctor.err() == "wheelwright: interrupted; the robot is at rest\n");
  CHECK(tap.drive_orders().first_standing.has_value());
  std::this_thread::sleep_for(500ms);
  robot->end();
  const Table truth = bench.truth();
  CHECK_THAT(truth.number(truth.rows() - 1, "speed_left"), WithinAbs(0.0, 0.001));
}

TEST_CASE("a doctor without a device is bad usage") {
  Bench bench;
  const auto doctor = start_doctor(bench);
  CHECK(doctor->wait(2s) == 2);
  CHECK_THAT(doctor->err(), ContainsSubstring("no such device"));
}

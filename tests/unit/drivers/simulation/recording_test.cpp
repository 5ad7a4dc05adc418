#include "drivers/simulation/recording.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;
using wheelwright::DriveLog;

namespace {

DriveLog short_log() {
  DriveLog log;
  log.name = "short.csv";
  log.samples.resize(4);
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    log.samples[i].t_s = 0.5 * static_cast<double>(i);
    log.samples[i].ticks = {100 * static_cast<std::int64_t>(i), 32760 + 10 * static_cast<std::int64_t>(i)};
    log.samples[i].command_m_s = i == 0 ? wheelwright::WheelPair{} : wheelwright::WheelPair{0.078, -0.05};
  }
  return log;
}

}  // namespace

TEST_CASE("A replaying robot waits at the first command and then answers what was recorded") {
  Host host(SimulatedRobot(SimulationConfig{}, recording_of(short_log())));
  host.start();
  host.robot.advance(3s);
  CHECK(host.packet(43) == 100);
  CHECK(host.packet(42) == 0);
  host.drive(200, 200);
  host.robot.advance(100ms);
  CHECK(host.packet(43) == 100);
  CHECK(host.packet(42) == 78);
  CHECK(host.packet(41) == -50);
  host.robot.advance(500ms);
  CHECK(host.packet(43) == 200);
  CHECK(host.packet(44) == 32780 - 65536);
  host.robot.advance(5s);
  CHECK(host.packet(43) == 300);
}

TEST_CASE("A command to stand does not start the recording") {
  Host host(SimulatedRobot(SimulationConfig{}, recording_of(short_log())));
  host.start();
  host.drive(0, 0);
  host.robot.advance(3s);
  CHECK(host.packet(43) == 100);
  CHECK(host.packet(42) == 0);
  host.drive(0, 50);
  host.robot.advance(600ms);
  CHECK(host.packet(43) == 200);
}

TEST_CASE("A log without counts cannot be replayed") {
  DriveLog log = short_log();
  for (auto& sample : log.samples) sample.ticks.reset();
  CHECK_THROWS_WITH(recording_of(log), ContainsSubstring("short.csv"));
}

// Robots whose firmware reports the mode plus one, and robots that come and go.
#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/linked_robot.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright;
using namespace wheelwright::roomba;
using namespace std::chrono_literals;
using open_interface::Bytes;
using simulation::Fault;

namespace {

simulation::SimulationConfig robot_config(bool mode_plus_one) {
  simulation::SimulationConfig config;
  config.link.mode_plus_one = mode_plus_one;
  return config;
}

LinkConfig streaming() {
  LinkConfig config;
  config.transport = Transport::stream;
  return config;
}

}  // namespace

TEST_CASE("A robot that falls out of Safe mode is noticed, whichever way it counts its modes") {
  for (const bool plus_one : {false, true}) {
    INFO(plus_one);
    LinkedRobot linked(LinkConfig{}, robot_config(plus_one));
    linked.start();
    REQUIRE(linked.link.armed());
    linked.drive_for(50, 0.1, 0.1);
    CHECK(linked.link.armed());
    linked.robot.receive(Bytes{128});
    CHECK(linked.drive_for(3, 0.1, 0.1).stop == StopReason::mode_changed);
  }
}

TEST_CASE("It is noticed as well when the link was asked to arm before the robot answered") {
  for (const bool plus_one : {false, true}) {
    INFO(plus_one);
    LinkedRobot linked(LinkConfig{}, robot_config(plus_one));
    linked.link.arm();
    linked.drive_for(30, 0.1, 0.1);
    REQUIRE(linked.link.armed());
    linked.robot.receive(Bytes{128});
    CHECK(linked.drive_for(3, 0.1, 0.1).stop == StopReason::mode_changed);
  }
}

TEST_CASE("It is noticed as well after the port was lost and opened again") {
  for (const bool plus_one : {false, true}) {
    INFO(plus_one);
    LinkedRobot linked(LinkConfig{}, robot_config(plus_one));
    linked.start();
    linked.drive_for(50, 0.1, 0.1);
    linked.link.stop(StopReason::link_lost);
    linked.link.port_closed();
    linked.drive_for(20, 0.1, 0.1);
    linked.link.port_opened();
    linked.drive_for(40, 0.1, 0.1);
    CHECK(linked.link.stop_reason() == StopReason::link_lost);
    linked.start();
    linked.drive_for(20, 0.1, 0.1);
    REQUIRE(linked.link.armed());
    linked.robot.receive(Bytes{128});
    CHECK(linked.drive_for(3, 0.1, 0.1).stop == StopReason::mode_changed);
  }
}

TEST_CASE("Counts go on from the same total after the port was lost, and the frame says so") {
  LinkedRobot linked(LinkConfig{}, robot_config(false));
  linked.start();
  const SensorFrame before = linked.drive_for(100, 0.2, 0.2);
  linked.link.port_closed();
  linked.robot.inject({.kind = Fault::Kind::power_off});
  linked.robot.inject({.kind = Fault::Kind::add_counts, .counts = 20000});
  linked.drive_for(60, 0.0, 0.0);
  linked.robot.inject({.kind = Fault::Kind::power_on});
  linked.link.port_opened();
  SensorFrame after;
  for (int i = 0; i < 300 && !after.valid; ++i) after = linked.drive(0.0, 0.0);
  REQUIRE(after.valid);
  CHECK(after.after_gap);
  CHECK(std::abs(after.ticks.left - before.ticks.left) <= 40);
  CHECK(std::abs(after.ticks.right - before.ticks.right) <= 40);
  CHECK(!linked.drive(0.0, 0.0).after_gap);
  CHECK(linked.link.counts().implausible == 0);
}

TEST_CASE("A counter that jumps is not believed for three samples, then it has a new origin") {
  LinkedRobot linked(LinkConfig{}, robot_config(false));
  linked.start();
  const SensorFrame before = linked.drive_for(50, 0.1, 0.1);
  linked.robot.inject({.kind = Fault::Kind::add_counts, .side = simulation::Side::left, .counts = -9000});
  int invalid = 0;
  for (int i = 0; i < 10; ++i) {
    const SensorFrame frame = linked.drive(0.1, 0.1);
    invalid += frame.valid ? 0 : 1;
    CHECK(frame.ticks.left >= before.ticks.left);
    CHECK(frame.ticks.left <= before.ticks.left + 60);
  }
  CHECK(invalid == 3);
  CHECK(linked.link.counts().implausible == 3);
  CHECK(linked.link.armed());
}

TEST_CASE("A robot that another program left streaming is asked and answers in peace") {
  LinkedRobot linked(LinkConfig{}, robot_config(false));
  linked.robot.receive(Bytes{128, 148, 1, 100});
  linked.robot.advance(100ms);
  linked.start();
  REQUIRE(linked.link.armed());
  const auto before = linked.link.reply_counts();
  linked.drive_for(100, 0.1, 0.1);
  CHECK(linked.link.reply_counts().stray_bytes == before.stray_bytes);
  CHECK(linked.link.reply_counts().sound == before.sound + 100);
}

TEST_CASE("A robot that boots while it is being asked is not reset for ever by the 7 in the question") {
  for (const auto& transport : {LinkConfig{}, streaming()}) {
    for (int boot_ms = 200; boot_ms < 4000; boot_ms += 150) {
      INFO(boot_ms);
      auto config = robot_config(false);
      config.link.boot_time_s = 0.001 * boot_ms;
      LinkedRobot linked(transport, config);
      linked.robot.receive(Bytes{7});
      linked.robot.advance(5ms);
      linked.drive_for(static_cast<int>((5.0 + 3.0 * config.link.boot_time_s) / 0.018), 0.0, 0.0);
      CHECK(linked.link.state() == LinkState::running);
    }
  }
}

TEST_CASE("The stream is asked for again after the port was opened again") {
  LinkedRobot linked(streaming(), robot_config(false));
  linked.start();
  REQUIRE(linked.link.armed());
  linked.link.port_closed();
  linked.robot.inject({.kind = Fault::Kind::power_off});
  linked.robot.advance(500ms);
  linked.robot.inject({.kind = Fault::Kind::power_on});
  linked.link.port_opened();
  linked.start();
  CHECK(linked.link.armed());
}

// But for Baud, which this project never sends: zero is its code for 300 baud. Half a drive command ends as
// one with zeros in it, which acts for the time of the padding.
TEST_CASE("Padding ends every half-sent command and the robot stays where it is") {
  std::vector<Bytes> commands{{7},
                              {137, 0, 0, 0x80, 0},
                              {138, 7},
                              {139, 1, 2, 3},
                              {140, 0, 16},
                              {141, 0},
                              {142, 7},
                              {144, 1, 2, 3},
                              {145, 0x01, 0x2C, 0x01, 0x2C},
                              {145, 0xFE, 0xD4, 0xFE, 0xD4},
                              {146, 0, 255, 0, 255},
                              {146, 0xFF, 1, 0xFF, 1},
                              {148, 23},
                              {149, 23},
                              {150, 1},
                              {162, 1, 2},
                              {163, 1, 2, 3, 4},
                              {164, 65, 66, 67, 68},
                              {165, 1},
                              {167},
                              {168, 1, 2, 3}};
  for (const Bytes& command : commands) {
    for (std::size_t sent = 1; sent <= command.size(); ++sent) {
      if (sent == command.size() && (command[0] == 145 || command[0] == 146 || command[0] == 7)) continue;
      INFO("opcode " << static_cast<int>(command[0]) << ", " << sent << " bytes sent");
      LinkedRobot linked(LinkConfig{}, robot_config(false));
      linked.robot.receive(Bytes{128, 131});
      linked.robot.advance(30ms);
      linked.robot.receive(std::span(command).first(sent));
      linked.robot.advance(30ms);
      linked.link.port_opened();
      linked.start();
      CHECK(linked.link.armed());
      const double travel_mm =
          0.445 * std::max(std::abs(linked.true_ticks.left), std::abs(linked.true_ticks.right));
      CHECK(travel_mm < 0.6);
    }
  }
}

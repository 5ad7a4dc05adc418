#include "drivers/roomba/roomba_link.hpp"

#include <limits>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/link_bench.hpp"

using namespace wheelwright;
using namespace wheelwright::roomba;
using open_interface::Bytes;
using open_interface::PacketId;

TEST_CASE("A port that was opened gets padding, zeros and Start before anything else") {
  Bench bench;
  bench.tick(std::nullopt);
  const auto& bytes = bench.written;
  REQUIRE(bytes.size() > 40);
  CHECK(Bytes(bytes.begin(), bytes.begin() + 40) == Bytes(40, 0));
  CHECK(Bytes(bytes.begin() + 40, bytes.begin() + 45) == drive_zeros);
  CHECK(bytes.at(45) == 128);
}

TEST_CASE("A robot that does not answer is started again, once a second or so") {
  Bench bench;
  int starts = 0;
  for (int i = 0; i < 500; ++i) {
    bench.tick(std::nullopt, false);
    starts += contains(bench.written, {0, 0, 0, 128}) ? 1 : 0;
  }
  CHECK(starts == 10);
}

TEST_CASE("Nothing is armed until it is asked for, and then not before the robot obeys") {
  Bench bench;
  for (int i = 0; i < 100; ++i) {
    const SensorFrame frame = bench.drive(0.2, 0.2);
    CHECK(!frame.armed);
    CHECK(!moves(bench.written));
  }
  bench.link.arm();
  for (int i = 0; i < 20; ++i) {
    CHECK(!bench.drive(0.2, 0.2).armed);
    CHECK(contains(bench.written, {131}));
    CHECK(!moves(bench.written));
  }
  bench.says[PacketId::oi_mode] = 2;
  CHECK(bench.drive(0.2, 0.2).armed);
  CHECK(!moves(bench.written));
  bench.drive(0.2, 0.2);
  CHECK(contains(bench.written, {145, 0, 200, 0, 200}));
}

TEST_CASE("A robot that does not obey within a second is not armed") {
  Bench bench;
  while (bench.link.state() != LinkState::running) bench.tick(std::nullopt);
  bench.link.arm();
  for (int i = 0; i < 60; ++i) bench.drive(0.1, 0.1);
  CHECK(bench.link.stop_reason() == StopReason::mode_changed);
  bench.says[PacketId::oi_mode] = 2;
  CHECK(!bench.drive(0.1, 0.1).armed);
}

TEST_CASE("What is asked to be armed before the robot has woken up is armed once it has") {
  Bench bench;
  bench.link.arm();
  for (int i = 0; i < 200; ++i) bench.tick(std::nullopt, false);
  bench.tick(std::nullopt);
  bench.says[PacketId::oi_mode] = 2;
  for (int i = 0; i < 3; ++i) bench.drive(0.0, 0.0);
  CHECK(bench.link.armed());
}

TEST_CASE("The right wheel goes first and both are limited to the configured speed") {
  Bench bench;
  bench.start();
  bench.drive(0.1, -0.05);
  CHECK(contains(bench.written, {145, 0xFF, 0xCE, 0, 100}));
  bench.drive(5.0, -5.0);
  CHECK(contains(bench.written, {145, 0xFE, 0xD4, 0x01, 0x2C}));
}

TEST_CASE("In PWM mode a command is duty") {
  LinkConfig config;
  config.drive_mode = DriveMode::pwm;
  Bench bench(config);
  bench.start();
  bench.drive(0.25, -0.1);
  CHECK(contains(bench.written, {146, 0xFF, 0xCD, 0, 128}));
}

TEST_CASE("A command that is no number does not move the robot") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Bench bench;
    bench.start();
    bench.drive(bad, -bad);
    CHECK(!moves(bench.written));
  }
}

TEST_CASE("Each danger stops the wheels in its own tick and stays until the link is armed again") {
  struct Danger {
    PacketId packet;
    int value;
    StopReason reason;
  };
  for (const Danger& danger : {Danger{PacketId::bumps_and_wheel_drops, 1, StopReason::bump},
                               Danger{PacketId::bumps_and_wheel_drops, 2, StopReason::bump},
                               Danger{PacketId::bumps_and_wheel_drops, 4, StopReason::wheel_drop},
                               Danger{PacketId::bumps_and_wheel_drops, 8, StopReason::wheel_drop},
                               Danger{PacketId::cliff_left, 1, StopReason::cliff},
                               Danger{PacketId::cliff_front_left, 1, StopReason::cliff},
                               Danger{PacketId::cliff_front_right, 1, StopReason::cliff},
                               Danger{PacketId::cliff_right, 1, StopReason::cliff},
                               Danger{PacketId::overcurrents, 8, StopReason::overcurrent},
                               Danger{PacketId::overcurrents, 16, StopReason::overcurrent},
                               Danger{PacketId::charging_state, 2, StopReason::charging},
                               Danger{PacketId::voltage, 11999, StopReason::low_battery},
                               Danger{PacketId::oi_mode, 1, StopReason::mode_changed},
                               Danger{PacketId::oi_mode, 0, StopReason::mode_changed}}) {
    INFO(name_of(danger.reason));
    Bench bench;
    bench.start();
    bench.drive(0.2, 0.2);
    const int before = bench.says[danger.packet];
    bench.says[danger.packet] = danger.value;
    const SensorFrame frame = bench.drive(0.2, 0.2);
    CHECK(bench.urgent == drive_zeros);
    CHECK(frame.stop == danger.reason);
    CHECK(!frame.armed);
    bench.says[danger.packet] = before;
    for (int i = 0; i < 100; ++i) {
      CHECK(bench.drive(0.2, 0.2).stop == danger.reason);
      CHECK(!moves(bench.written));
      CHECK(contains(bench.written, drive_zeros));
      CHECK(!contains(bench.written, {131}));
    }
    bench.link.arm();
    bench.drive(0.2, 0.2);
    CHECK(bench.drive(0.2, 0.2).armed);
    CHECK(moves(bench.written));
  }
}

TEST_CASE("Arming on top of a danger that is still there stops at once") {
  Bench bench;
  bench.start();
  bench.says[PacketId::cliff_left] = 1;
  bench.drive(0.2, 0.2);
  bench.link.arm();
  CHECK(bench.drive(0.2, 0.2).stop == StopReason::cliff);
  CHECK(!moves(bench.written));
}

TEST_CASE("Brushes that draw too much and a charging fault do not stop the wheels") {
  Bench bench;
  bench.start();
  bench.says[PacketId::overcurrents] = 5;
  bench.says[PacketId::charging_state] = 5;
  CHECK(bench.drive(0.1, 0.1).stop == StopReason::none);
}

TEST_CASE("Blind for the configured time the wheels are stopped, and later the link is lost") {
  Bench bench;
  bench.start();
  bench.drive(0.2, 0.2);
  int blind_ticks = 0;
  while (bench.link.armed() && blind_ticks < 100) {
    bench.drive(0.2, 0.2, false);
    ++blind_ticks;
  }
  CHECK(blind_ticks == 14);  // 0.25 s of 18 ms
  CHECK(bench.urgent == drive_zeros);
  CHECK(bench.link.stop_reason() == StopReason::blind);
  while (bench.link.state() == LinkState::running && blind_ticks < 100) {
    bench.drive(0.2, 0.2, false);
    CHECK(!moves(bench.written));
    ++blind_ticks;
  }
  CHECK(blind_ticks == 56);
  CHECK(bench.link.state() == LinkState::lost);
  CHECK(bench.link.counts().times_lost == 1);
}

TEST_CASE("A command that does not come is held for three ticks, then the wheels are stopped") {
  Bench bench;
  bench.start();
  bench.drive(0.2, 0.1);
  for (int i = 0; i < 3; ++i) {
    bench.tick(std::nullopt);
    CHECK(contains(bench.written, {145, 0, 100, 0, 200}));
  }
  CHECK(bench.tick(std::nullopt).stop == StopReason::late_command);
  CHECK(!moves(bench.written));
  CHECK(contains(bench.written, drive_zeros));
  CHECK(bench.link.counts().late_commands == 4);
}

TEST_CASE(
    "Lost replies leave no time for commands: the last one is held up to the blind limit, and none counts as "
    "late") {
  Bench bench;
  bench.start();
  bench.drive(0.2, 0.1);
  bench.tick(std::nullopt, false);
  for (int i = 0; i < 9; ++i) {
    bench.tick(std::nullopt, false);
    CHECK(contains(bench.written, {145, 0, 100, 0, 200}));
  }
  CHECK(bench.link.armed());
  int more = 0;
  while (bench.link.armed() && more < 20) {
    bench.tick(std::nullopt, false);
    ++more;
  }
  CHECK(bench.link.stop_reason() == StopReason::blind);
}

TEST_CASE("Whatever happens, nothing but zeros is sent while the link is not armed") {
  open_interface::Random random(51);
  for (int run = 0; run < 30; ++run) {
    Bench bench;
    for (int i = 0; i < 600; ++i) {
      const int event = open_interface::between(random, 0, 60);
      if (event == 0) bench.link.arm();
      if (event == 1) bench.link.stop(StopReason::requested);
      if (event == 2) bench.link.port_closed();
      if (event == 3) bench.link.port_opened();
      bench.says[PacketId::oi_mode] = open_interface::between(random, 0, 30) == 0 ? 1 : 2;
      bench.says[PacketId::bumps_and_wheel_drops] = event == 4 ? 1 : 0;
      const bool armed_before = bench.link.armed();
      Command command;
      command.speed_m_s = {0.2, -0.2};
      bench.tick(event == 5 ? std::nullopt : std::optional(command), event > 12);
      REQUIRE((armed_before || !moves(bench.written)));
      REQUIRE(!moves(bench.urgent));
      REQUIRE((bench.link.armed() || bench.link.stop_reason() == StopReason::none || !armed_before ||
               contains(bench.urgent, drive_zeros) || contains(bench.written, drive_zeros) ||
               bench.written.empty()));
    }
  }
}

TEST_CASE("The farewell puts the wheels to rest, then goes to Passive, then Off") {
  Bench bench;
  bench.start();
  bench.drive(0.2, 0.2);
  const auto bytes = bench.link.farewell_bytes();
  CHECK(Bytes(bytes.begin(), bytes.end()) == Bytes{145, 0, 0, 0, 0, 128, 173});
}

TEST_CASE("What is written in one tick fits the line at 115200 baud") {
  Bench bench;
  bench.tick(std::nullopt);
  CHECK(bench.written.size() <= 80);
  bench.start();
  bench.drive(0.2, 0.2);
  CHECK(bench.written.size() == 5 + 2 + 23);
  CHECK(bench.written.size() * 10 <= static_cast<std::size_t>(115200 * 0.018));
}

TEST_CASE("After a reply that failed the robot is told not to stream, in case damage made it") {
  Bench bench;
  bench.start();
  bench.drive(0.1, 0.1);
  CHECK(!contains(bench.written, {150, 0}));
  bench.drive(0.1, 0.1, false);
  bench.drive(0.1, 0.1);
  CHECK(contains(bench.written, {150, 0, 149}));
  bench.drive(0.1, 0.1);
  CHECK(!contains(bench.written, {150, 0}));
}

TEST_CASE(
    "A robot still in Safe mode, which the first Start has not reached, is told again and can be armed") {
  Bench bench;
  bench.says[PacketId::oi_mode] = 2;
  while (bench.link.state() != LinkState::running) bench.tick(std::nullopt);
  bench.tick(std::nullopt);
  REQUIRE(contains(bench.written, {128}));
  bench.says[PacketId::oi_mode] = 1;  // it has received it
  bench.tick(std::nullopt);
  bench.link.arm();
  bench.tick(std::nullopt);
  bench.says[PacketId::oi_mode] = 2;
  bench.drive(0.0, 0.0);
  bench.drive(0.0, 0.0);
  CHECK(bench.link.armed());
}

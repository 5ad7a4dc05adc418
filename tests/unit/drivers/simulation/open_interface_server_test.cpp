#include "drivers/simulation/open_interface_server.hpp"

#include <numeric>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;
using wheelwright::open_interface::PacketId;

namespace {

// The frame of the worked example in both documents: packets 29 (value 537) and 13 (value 0).
Bytes worked_example(bool checksum_excludes_header) {
  SimulationConfig config;
  config.link.checksum_excludes_header = checksum_excludes_header;
  Noise noise(1);
  Mechanics mechanics(config, noise);
  SensorBoard sensors(config);
  SerialLine from_host(SerialLine::Sender::host, 115200, 256, {}, 0.0);
  SerialLine to_host(SerialLine::Sender::robot, 115200, 256, {}, 0.0);
  OpenInterfaceServer server(config, mechanics, sensors, from_host, to_host, noise);
  for (const std::uint8_t byte : Bytes{128, 148, 2, 29, 13}) server.receive(byte, 0ms);
  sensors.set(PacketId::cliff_front_left_signal, 537);
  server.sensor_tick(15ms);
  Bytes frame;
  for (std::size_t i = 0; i < to_host.under_way(); ++i) frame.push_back(to_host.at(i).byte);
  return frame;
}

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST_CASE("Stream frames carry the checksum of the Create 2 document, or of the Roomba 500 document") {
  CHECK(worked_example(false) == Bytes{19, 5, 29, 2, 25, 13, 0, 163});
  CHECK(worked_example(true) == Bytes{19, 5, 29, 2, 25, 13, 0, 182});
}

TEST_CASE("A robot in Off mode answers nothing but Start") {
  Host host{SimulationConfig{}};
  CHECK(host.ask({142, 35}).empty());
  CHECK(host.ask({131, 142, 35}).empty());
  CHECK(host.ask({128, 142, 35}) == Bytes{1});
}

TEST_CASE("Mode commands lead to their modes") {
  Host host{SimulationConfig{}};
  CHECK(host.ask({128, 142, 35}) == Bytes{1});
  CHECK(host.ask({131, 142, 35}) == Bytes{2});
  CHECK(host.ask({132, 142, 35}) == Bytes{3});
  CHECK(host.ask({130, 142, 35}) == Bytes{2});
  CHECK(host.ask({135, 142, 35}) == Bytes{1});
  CHECK(host.ask({173, 142, 35}).empty());
}

TEST_CASE("Some firmware reports its mode plus one") {
  SimulationConfig config;
  config.link.mode_plus_one = true;
  Host host(config);
  CHECK(host.ask({128, 132, 142, 35}) == Bytes{4});
}

TEST_CASE("Drive commands act in Safe and Full mode only") {
  Host host{SimulationConfig{}};
  host.ask({128});
  host.drive(200, 200);
  host.robot.advance(1s);
  CHECK(host.robot.truth().wheels_at_rest);
  host.ask({131});
  host.drive(200, 200);
  host.robot.advance(1s);
  CHECK(host.robot.truth().v_m_s > 0.15);
  host.ask({128});
  host.robot.advance(1s);
  CHECK(host.robot.truth().wheels_at_rest);
}

TEST_CASE("A half-sent command swallows the bytes that follow") {
  Host host{SimulationConfig{}};
  host.start();
  host.send({145, 0, 100});
  host.robot.advance(10s);
  CHECK(host.ask({142, 35}).empty());
  CHECK(host.ask({142, 35}) == Bytes{2});
}

TEST_CASE("Bytes that are no opcode are passed over") {
  Host host{SimulationConfig{}};
  host.start();
  CHECK(host.ask({0, 0, 0, 255, 200, 19, 142, 35}) == Bytes{2});
}

TEST_CASE("Commands with data of their own length are taken whole") {
  Host host{SimulationConfig{}};
  host.start();
  const Bytes probe{142, 35};
  for (Bytes command : {Bytes{140, 0, 2, 128, 64, 128, 64}, Bytes{138, 128}, Bytes{139, 128, 128, 128},
                        Bytes{144, 128, 128, 128}, Bytes{162, 128, 128}, Bytes{163, 128, 128, 128, 128},
                        Bytes{164, 128, 128, 128, 128}, Bytes{168, 128, 128, 128},
                        Bytes{167, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128, 128},
                        Bytes{148, 2, 128, 128, 150, 0}, Bytes{141, 128}, Bytes{165, 128}}) {
    command.insert(command.end(), probe.begin(), probe.end());
    CHECK(host.ask(command) == Bytes{2});
  }
}

TEST_CASE("A query list answers with the bare packets in order, groups included") {
  Host host{SimulationConfig{}};
  host.start();
  CHECK(host.ask({149, 3, 35, 43, 35}) == Bytes{2, 0, 0, 2});
  const std::vector<std::pair<std::uint8_t, std::size_t>> groups{{0, 26},   {1, 10},   {2, 6},  {3, 10},
                                                                 {4, 14},   {5, 12},   {6, 52}, {100, 80},
                                                                 {101, 28}, {106, 12}, {107, 9}};
  for (const auto& [group, size] : groups) CHECK(host.ask({142, group}).size() == size);
}

TEST_CASE("The stream sends a frame per sensor period, and pauses and resumes with the same list") {
  Host host{SimulationConfig{}};
  host.start();
  host.send({148, 2, 43, 35});
  host.robot.advance(1s);
  const Bytes frames = host.read();
  CHECK(frames.size() % 8 == 0);
  CHECK(frames.size() / 8 >= 63);
  CHECK(frames.size() / 8 <= 64);
  CHECK(std::accumulate(frames.begin(), frames.begin() + 8, 0U) % 256U == 0);
  host.ask({150, 0});
  CHECK(host.ask({}, 1s).empty());
  CHECK(host.ask({150, 1}, 1s).size() >= 62 * 8);
}

TEST_CASE("Sensor values change once per refresh only") {
  SimulationConfig config;
  config.firmware.sensor_update_period_s = 0.1;
  Host host(config);
  host.start();
  host.drive(300, 300);
  host.robot.advance(1s);
  int changes = 0;
  std::int32_t last = host.packet(43, 2ms);
  for (int i = 0; i < 500; ++i) {
    const std::int32_t now = host.packet(43, 2ms);
    changes += now != last ? 1 : 0;
    last = now;
  }
  CHECK(changes == 10);
}

TEST_CASE("In Safe mode a wheel drop, a charger and a cliff ahead stop the wheels and lead to Passive") {
  Host host{SimulationConfig{}};
  const auto drive_in_safe = [&] {
    host.start();
    host.drive(200, 200);
    host.robot.advance(500ms);
    REQUIRE(host.robot.truth().oi_mode == 2);
  };
  drive_in_safe();
  host.robot.inject({.kind = Fault::Kind::lift_wheel, .side = Side::right});
  host.robot.advance(40ms);
  CHECK(host.packet(7) == 4);
  CHECK(host.packet(35) == 1);
  host.robot.inject({.kind = Fault::Kind::set_down_wheel, .side = Side::right});
  drive_in_safe();
  host.robot.inject({.kind = Fault::Kind::plug_charger});
  host.robot.advance(40ms);
  CHECK(host.packet(35) == 1);
}

TEST_CASE("A cliff stops a robot in Safe mode before its wheels reach it, and not one in Full mode") {
  auto config = shipped_robot("perfect.yaml");
  config.room = shipped_room("stairs.yaml");
  config.firmware.tick_s = 0.015625;
  config.firmware.sensor_update_period_s = 0.015625;
  Host safe(config);
  safe.start();
  safe.drive(200, 200);
  safe.robot.advance(10s);
  CHECK(safe.robot.truth().oi_mode == 1);
  CHECK(safe.robot.truth().pose.x_m < 1.0);
  Host full(config);
  full.start(132);
  full.drive(200, 200);
  full.robot.advance(10s);
  CHECK(full.robot.truth().oi_mode == 3);
  CHECK((full.packet(7) & 12) == 12);
}

TEST_CASE("Reset prints the boot text, is deaf meanwhile, and ends in Off mode at the first speed") {
  SimulationConfig config;
  Host host(config);
  host.start();
  CHECK(text_of(host.ask({7}, 500ms)) == config.link.boot_text);
  CHECK(host.ask({128, 142, 35}).empty());
  host.robot.advance(1s);
  CHECK(host.ask({142, 35}).empty());
  CHECK(host.ask({128, 142, 35}) == Bytes{1});
}

TEST_CASE("After five minutes in Passive the robot sleeps until its Clean button is pressed") {
  Host host{SimulationConfig{}};
  host.ask({128});
  host.robot.advance(299s);
  CHECK(host.ask({142, 35}) == Bytes{1});
  host.robot.advance(301s);
  CHECK(host.ask({128, 142, 35}).empty());
  host.robot.inject({.kind = Fault::Kind::press_clean});
  CHECK(host.ask({128, 142, 35}) == Bytes{1});
  host.ask({131});
  host.robot.advance(600s);
  CHECK(host.ask({142, 35}) == Bytes{2});
}

TEST_CASE("Without power the robot is silent and its wheels are off") {
  Host host{SimulationConfig{}};
  host.start();
  host.drive(200, 200);
  host.robot.advance(1s);
  host.robot.inject({.kind = Fault::Kind::power_off});
  host.robot.advance(3s);
  CHECK(host.ask({128, 142, 35}).empty());
  CHECK(host.robot.truth().wheels_at_rest);
  host.robot.inject({.kind = Fault::Kind::power_on});
  CHECK_THAT(text_of(host.ask({}, 2s)), ContainsSubstring("bl-start"));
  CHECK(host.ask({128, 142, 35}) == Bytes{1});
}

TEST_CASE("Stray text comes between the answers at its interval") {
  SimulationConfig config;
  config.link.stray_text = "hello\r\n";
  config.link.stray_text_interval_s = 1.0;
  Host host(config);
  CHECK(text_of(host.ask({}, 3500ms)) == "hello\r\nhello\r\nhello\r\n");
}

TEST_CASE("Distance and angle start again from zero when they have been asked for") {
  Host host{SimulationConfig{}};
  host.start();
  host.drive(200, 200);
  host.robot.advance(1s);
  CHECK(host.packet(19) > 150);
  CHECK(host.packet(19, 2ms) < 10);
}

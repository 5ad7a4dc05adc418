#include "drivers/simulation/serial_line.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;

namespace {

SerialLine plain_line(int baud) {
  return SerialLine(SerialLine::Sender::robot, baud, 256, {}, 0.0);
}

}  // namespace

TEST_CASE("Bytes on the line arrive ten bits apart") {
  Noise noise(1);
  SerialLine line = plain_line(115200);
  for (std::uint8_t i = 0; i < 84; ++i) line.send(i, 5ms, noise);
  CHECK_THAT(1e-9 * static_cast<double>((line.at(0).at - 5ms).count()), WithinAbs(10.0 / 115200, 1e-9));
  CHECK_THAT(1e-9 * static_cast<double>((line.at(83).at - 5ms).count()), WithinAbs(840.0 / 115200, 1e-7));
}

TEST_CASE("An answer of 80 bytes needs 7 ms after a query of 2 bytes at 115200 baud") {
  Host host{SimulationConfig{}};
  host.start();
  host.send({142, 100});
  host.robot.advance(std::chrono::microseconds(82 * 86));
  CHECK(host.read().size() == 79);
  host.robot.advance(100us);
  CHECK(host.read().size() == 1);
}

TEST_CASE("Opcode 129 slows the line down to the new speed") {
  Host host{SimulationConfig{}};
  host.start();
  host.ask({129, 7});  // 19200
  host.send({142, 100});
  host.robot.advance(21ms);
  const std::size_t early = host.read().size();
  CHECK(early > 35);
  CHECK(early < 42);
}

TEST_CASE("A host that listens at another speed hears garbage") {
  Host host{SimulationConfig{}};
  host.start();
  host.robot.set_host_baud(19200);
  host.send({142, 35});
  host.robot.advance(20ms);
  host.robot.set_host_baud(115200);
  host.ask({0, 0, 0, 0}, 50ms);
  CHECK(host.packet(35) != -99999);
}

TEST_CASE("A sender that gets ahead of the line loses what its buffer cannot hold") {
  Noise noise(1);
  SerialLine line = plain_line(115200);
  for (int i = 0; i < 1000; ++i) line.send(0, 0ms, noise);
  CHECK(line.under_way() == 256);
}

TEST_CASE("A USB converter hands bytes on when its timer fires or a packet is full") {
  Noise noise(1);
  SerialLine line = plain_line(115200);
  Receiver receiver(0.016, 62);
  for (int i = 0; i < 84; ++i) line.send(0, 0ms, noise);
  CHECK(receiver.readable(line, 5ms) == 0);
  CHECK(receiver.readable(line, 6ms) == 62);
  CHECK(receiver.readable(line, 15ms) == 62);
  CHECK(receiver.readable(line, 16ms) == 84);
}

TEST_CASE("Bytes are lost and damaged as often as configured") {
  Noise noise(3);
  SerialLine line(SerialLine::Sender::robot, 115200, SerialLine::capacity, {0.1, 0.2}, 0.0);
  int damaged = 0;
  constexpr int sent = 8000;
  for (int i = 0; i < sent; ++i) line.send(0, 0ms, noise);
  for (std::size_t i = 0; i < line.under_way(); ++i) damaged += line.at(i).byte != 0 ? 1 : 0;
  CHECK_THAT(static_cast<double>(line.under_way()) / sent, WithinAbs(0.9, 0.02));
  CHECK_THAT(static_cast<double>(damaged) / static_cast<double>(line.under_way()), WithinAbs(0.2, 0.02));
}

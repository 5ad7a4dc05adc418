#include "drivers/simulation/encoder.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;

namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;

Encoder encoder(EncoderSign sign, int start = 0) {
  EncoderConfig config;
  config.sign = sign;
  return {config, start};
}

}  // namespace

TEST_CASE("Ten wheel turns are 5088 counts") {
  Encoder counter = encoder(EncoderSign::true_direction);
  counter.look(10.0 * turn_rad + 1e-9, 1, 1);
  CHECK(counter.reading() == 5088);
  counter.look(0.0, 1, 1);
  CHECK(counter.reading() == 0);
}

TEST_CASE("The counter wraps at 16 bits in both directions") {
  Encoder counter = encoder(EncoderSign::true_direction, 65533);
  CHECK(static_cast<std::uint16_t>(counter.reading()) == 65533);
  counter.look(turn_rad * 6.5 / 508.8, 1, 1);
  CHECK(static_cast<std::uint16_t>(counter.reading()) == 3);
  counter.look(0.0, -1, -1);
  CHECK(static_cast<std::uint16_t>(counter.reading()) == 65533);
}

TEST_CASE("Without quadrature the command decides the sign, and a command of zero counts up") {
  Encoder counter = encoder(EncoderSign::command);
  counter.look(turn_rad, 1, 1);
  CHECK(counter.reading() == 508);
  counter.look(0.0, 1, -1);  // pushed back against a forward command
  CHECK(counter.reading() == 1016);
  counter.look(turn_rad, -1, 1);
  CHECK(counter.reading() == 508);
  counter.look(0.0, 0, -1);  // coasting backwards after a stop
  CHECK(counter.reading() == 1016);
}

TEST_CASE("A frozen counter loses what passes meanwhile") {
  Encoder counter = encoder(EncoderSign::true_direction);
  counter.freeze(true);
  counter.look(turn_rad, 1, 1);
  counter.freeze(false);
  CHECK(counter.reading() == 0);
  counter.add(100);
  CHECK(counter.reading() == 100);
}

TEST_CASE("Coasting out of a reverse drive counts up on the default robot") {
  Host host(shipped_robot("default.yaml"));
  host.start();
  host.drive(-300, -300);
  host.robot.advance(1s);
  host.drive(0, 0);
  auto lowest = host.robot.truth().counts_left;
  for (int ms = 0; ms < 500; ++ms) {
    host.robot.advance(1ms);
    lowest = std::min(lowest, host.robot.truth().counts_left);
  }
  CHECK(host.robot.truth().counts_left > lowest + 10);
}

TEST_CASE("Encoders can be swapped between the sides") {
  SimulationConfig config;
  config.encoder.swap_sides = true;
  Host host(config);
  host.start();
  host.drive(200, 0);
  host.robot.advance(1s);
  CHECK(host.packet(44) > 300);
  CHECK(std::abs(host.packet(43)) < 5);
}

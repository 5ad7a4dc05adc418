#include "drivers/open_interface/commands.hpp"

#include <stdexcept>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"

using namespace wheelwright::open_interface;

namespace {

Bytes bytes_of(const CommandBytes& command) {
  return {command.bytes().begin(), command.bytes().end()};
}

template <typename Build>
Bytes built(Build build) {
  CommandBytes command;
  build(command);
  return bytes_of(command);
}

}  // namespace

TEST_CASE("Drive Direct has the right wheel first and the high byte first") {
  CHECK(built([](auto& c) { c.drive_direct(200, -200); }) == Bytes{145, 0, 200, 255, 56});
  CHECK(built([](auto& c) { c.drive_direct(-500, 500); }) == Bytes{145, 0xFE, 0x0C, 0x01, 0xF4});
  CHECK(built([](auto& c) { c.drive_direct(0, 0); }) == Bytes{145, 0, 0, 0, 0});
}

TEST_CASE("Drive PWM has the right wheel first and the high byte first") {
  CHECK(built([](auto& c) { c.drive_pwm(255, -255); }) == Bytes{146, 0, 255, 0xFF, 0x01});
  CHECK(built([](auto& c) { c.drive_pwm(-1, 1); }) == Bytes{146, 0xFF, 0xFF, 0, 1});
}

TEST_CASE("Speeds and duties beyond the protocol's range are limited, not wrapped") {
  CHECK(built([](auto& c) { c.drive_direct(40000, -40000); }) ==
        built([](auto& c) { c.drive_direct(500, -500); }));
  CHECK(built([](auto& c) { c.drive_pwm(40000, -40000); }) == built([](auto& c) { c.drive_pwm(255, -255); }));
}

TEST_CASE("Commands without data are their opcodes") {
  CHECK(built([](auto& c) { c.start(); }) == Bytes{128});
  CHECK(built([](auto& c) { c.safe_mode(); }) == Bytes{131});
  CHECK(built([](auto& c) { c.full_mode(); }) == Bytes{132});
  CHECK(built([](auto& c) { c.stop_oi(); }) == Bytes{173});
  CHECK(built([](auto& c) { c.pause_stream(); }) == Bytes{150, 0});
}

TEST_CASE("Query list and stream carry the count and then the packets") {
  const std::array packets{PacketId::cliff_front_left_signal, PacketId::virtual_wall};
  CHECK(built([&](auto& c) { c.query_list(packets); }) == Bytes{149, 2, 29, 13});
  CHECK(built([&](auto& c) { c.stream(packets); }) == Bytes{148, 2, 29, 13});  // R500 p18
}

TEST_CASE("Commands are collected in order until they are cleared, and never beyond their memory") {
  CommandBytes command;
  command.start();
  command.safe_mode();
  command.drive_direct(1, 2);
  CHECK(bytes_of(command) == Bytes{128, 131, 145, 0, 1, 0, 2});
  command.clear();
  CHECK(command.bytes().empty());
  command.padding(256);
  CHECK(bytes_of(command) == Bytes(256, 0));
  CHECK_THROWS_AS(command.start(), std::length_error);
}

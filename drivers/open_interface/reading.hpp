// The sensors that the project uses, decoded: what a reply or a stream frame says.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "drivers/open_interface/packets.hpp"

namespace wheelwright::open_interface {

struct Reading {
  std::uint8_t bumps_and_wheel_drops = 0;
  bool cliff = false;  // any of the four
  std::uint8_t overcurrents = 0;
  std::uint8_t charging_state = 0;
  std::uint8_t charger_available = 0;
  std::uint8_t oi_mode = 0;
  int voltage_mv = 0;
  int current_ma = 0;
  std::uint16_t left_counts = 0;
  std::uint16_t right_counts = 0;
  std::array<std::uint16_t, 6> light_bumper{};  // left to right
  int left_motor_ma = 0;
  int right_motor_ma = 0;
};

// The packets of which a Reading is made, in the order in which they are asked for. Voltage and mode are not
// among them: the transport places those (query_reader.hpp).
std::span<const PacketId> reading_packets();

// Puts one packet's value into a reading. Returns false where the value is outside what a sound robot sends.
bool put(Reading& reading, const PacketInfo& packet, std::int32_t value);

// Voltages that a Roomba's battery can have; with its narrow range a good mark of alignment.
inline constexpr int lowest_voltage_mv = 6000;
inline constexpr int highest_voltage_mv = 24000;

}  // namespace wheelwright::open_interface

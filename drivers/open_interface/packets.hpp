// The sensor packets of the iRobot Open Interface, as one table.
//
// Source: iRobot "Roomba 500 Open Interface Specification" pages 17-33 and "Create 2 Open Interface" (2016).
// Multi-byte values travel with the high byte first.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace wheelwright::open_interface {

enum class PacketId : std::uint8_t {
  bumps_and_wheel_drops = 7,
  wall = 8,
  cliff_left = 9,
  cliff_front_left = 10,
  cliff_front_right = 11,
  cliff_right = 12,
  virtual_wall = 13,
  overcurrents = 14,
  dirt_detect = 15,
  unused_16 = 16,
  infrared_omni = 17,
  buttons = 18,
  distance = 19,
  angle = 20,
  charging_state = 21,
  voltage = 22,
  current = 23,
  temperature = 24,
  battery_charge = 25,
  battery_capacity = 26,
  wall_signal = 27,
  cliff_left_signal = 28,
  cliff_front_left_signal = 29,
  cliff_front_right_signal = 30,
  cliff_right_signal = 31,
  unused_32 = 32,
  unused_33 = 33,
  charger_available = 34,
  oi_mode = 35,
  song_number = 36,
  song_playing = 37,
  stream_packet_count = 38,
  requested_velocity = 39,
  requested_radius = 40,
  requested_right_velocity = 41,
  requested_left_velocity = 42,
  left_encoder_counts = 43,
  right_encoder_counts = 44,
  light_bumper = 45,
  light_bump_left_signal = 46,
  light_bump_front_left_signal = 47,
  light_bump_center_left_signal = 48,
  light_bump_center_right_signal = 49,
  light_bump_front_right_signal = 50,
  light_bump_right_signal = 51,
  infrared_left = 52,
  infrared_right = 53,
  left_motor_current = 54,
  right_motor_current = 55,
  main_brush_current = 56,
  side_brush_current = 57,
  stasis = 58,
};

// One row of the packet table.
struct PacketInfo {
  PacketId id;
  std::uint8_t bytes;  // 1 or 2
  bool is_signed;
  std::int32_t minimum;  // smallest value that a sound robot sends
  std::int32_t maximum;  // largest value that a sound robot sends
  std::string_view unit;
  std::string_view name;
};

// The whole table, ids 7 to 58 in rising order.
std::span<const PacketInfo> packet_table();

// The row of one packet, or nothing where the protocol has no such packet.
std::optional<PacketInfo> find_packet(std::uint8_t id);

// The row of a packet that the protocol has.
const PacketInfo& packet_info(PacketId id);

// The packets that make up a group (0 to 6, 100, 101, 106, 107) in the order in which they are sent; empty
// for a number that is no group.
std::span<const PacketInfo> packets_of_group(std::uint8_t group);

// The value of a packet from its bytes; `bytes` holds exactly packet.bytes bytes.
std::int32_t decode_value(const PacketInfo& packet, std::span<const std::uint8_t> bytes);

// Writes the value of a packet to its bytes, high byte first.
void encode_value(const PacketInfo& packet, std::int32_t value, std::span<std::uint8_t> bytes);

}  // namespace wheelwright::open_interface

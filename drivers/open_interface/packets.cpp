#include "drivers/open_interface/packets.hpp"

#include <array>
#include <cassert>
#include <cstddef>

namespace wheelwright::open_interface {
namespace {

using enum PacketId;

constexpr std::int32_t max_u16 = 65535;
constexpr std::int32_t min_s16 = -32768;
constexpr std::int32_t max_s16 = 32767;

constexpr std::uint8_t first_id = 7;
constexpr std::uint8_t last_id = 58;

// Ranges are the ones of the specification, widened where robots are known to exceed them: mode 4 is reported
// by some 600-series firmware, and the encoder counts are taken as signed, which holds for both readings of
// them.
constexpr std::array<PacketInfo, last_id - first_id + 1> table{{
    {bumps_and_wheel_drops, 1, false, 0, 15, "", "bumps and wheel drops"},
    {wall, 1, false, 0, 1, "", "wall"},
    {cliff_left, 1, false, 0, 1, "", "cliff left"},
    {cliff_front_left, 1, false, 0, 1, "", "cliff front left"},
    {cliff_front_right, 1, false, 0, 1, "", "cliff front right"},
    {cliff_right, 1, false, 0, 1, "", "cliff right"},
    {virtual_wall, 1, false, 0, 1, "", "virtual wall"},
    {overcurrents, 1, false, 0, 29, "", "overcurrents"},
    {dirt_detect, 1, false, 0, 255, "", "dirt detect"},
    {unused_16, 1, false, 0, 255, "", "unused"},
    {infrared_omni, 1, false, 0, 255, "", "infrared character omni"},
    {buttons, 1, false, 0, 255, "", "buttons"},
    {distance, 2, true, min_s16, max_s16, "mm", "distance"},
    {angle, 2, true, min_s16, max_s16, "deg", "angle"},
    {charging_state, 1, false, 0, 5, "", "charging state"},
    {voltage, 2, false, 0, max_u16, "mV", "voltage"},
    {current, 2, true, min_s16, max_s16, "mA", "current"},
    {temperature, 1, true, -128, 127, "degC", "battery temperature"},
    {battery_charge, 2, false, 0, max_u16, "mAh", "battery charge"},
    {battery_capacity, 2, false, 0, max_u16, "mAh", "battery capacity"},
    {wall_signal, 2, false, 0, 4095, "", "wall signal"},
    {cliff_left_signal, 2, false, 0, 4095, "", "cliff left signal"},
    {cliff_front_left_signal, 2, false, 0, 4095, "", "cliff front left signal"},
    {cliff_front_right_signal, 2, false, 0, 4095, "", "cliff front right signal"},
    {cliff_right_signal, 2, false, 0, 4095, "", "cliff right signal"},
    {unused_32, 1, false, 0, 255, "", "unused"},
    {unused_33, 2, false, 0, max_u16, "", "unused"},
    {charger_available, 1, false, 0, 3, "", "charging sources available"},
    {oi_mode, 1, false, 0, 4, "", "OI mode"},
    {song_number, 1, false, 0, 15, "", "song number"},
    {song_playing, 1, false, 0, 1, "", "song playing"},
    {stream_packet_count, 1, false, 0, 108, "", "number of stream packets"},
    {requested_velocity, 2, true, -500, 500, "mm/s", "requested velocity"},
    {requested_radius, 2, true, min_s16, max_s16, "mm", "requested radius"},
    {requested_right_velocity, 2, true, -500, 500, "mm/s", "requested right velocity"},
    {requested_left_velocity, 2, true, -500, 500, "mm/s", "requested left velocity"},
    {left_encoder_counts, 2, true, min_s16, max_s16, "ticks", "left encoder counts"},
    {right_encoder_counts, 2, true, min_s16, max_s16, "ticks", "right encoder counts"},
    {light_bumper, 1, false, 0, 127, "", "light bumper"},
    {light_bump_left_signal, 2, false, 0, 4095, "", "light bump left signal"},
    {light_bump_front_left_signal, 2, false, 0, 4095, "", "light bump front left signal"},
    {light_bump_center_left_signal, 2, false, 0, 4095, "", "light bump center left signal"},
    {light_bump_center_right_signal, 2, false, 0, 4095, "", "light bump center right signal"},
    {light_bump_front_right_signal, 2, false, 0, 4095, "", "light bump front right signal"},
    {light_bump_right_signal, 2, false, 0, 4095, "", "light bump right signal"},
    {infrared_left, 1, false, 0, 255, "", "infrared character left"},
    {infrared_right, 1, false, 0, 255, "", "infrared character right"},
    {left_motor_current, 2, true, min_s16, max_s16, "mA", "left motor current"},
    {right_motor_current, 2, true, min_s16, max_s16, "mA", "right motor current"},
    {main_brush_current, 2, true, min_s16, max_s16, "mA", "main brush motor current"},
    {side_brush_current, 2, true, min_s16, max_s16, "mA", "side brush motor current"},
    {stasis, 1, false, 0, 3, "", "stasis"},
}};

constexpr bool ids_rise_by_one() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (static_cast<std::size_t>(table[i].id) != i + first_id) return false;
  }
  return true;
}
static_assert(ids_rise_by_one(), "the packet table is looked up by position");

std::span<const PacketInfo> rows(PacketId first, PacketId last) {
  const auto from = static_cast<std::size_t>(first) - first_id;
  const auto to = static_cast<std::size_t>(last) - first_id;
  return std::span(table).subspan(from, to - from + 1);
}

}  // namespace

std::span<const PacketInfo> packet_table() {
  return table;
}

std::optional<PacketInfo> find_packet(std::uint8_t id) {
  if (id < first_id || id > last_id) return std::nullopt;
  return table[static_cast<std::size_t>(id) - first_id];
}

const PacketInfo& packet_info(PacketId id) {
  return table.at(static_cast<std::size_t>(id) - first_id);
}

std::span<const PacketInfo> packets_of_group(std::uint8_t group) {
  switch (group) {
    case 0:
      return rows(bumps_and_wheel_drops, battery_capacity);
    case 1:
      return rows(bumps_and_wheel_drops, unused_16);
    case 2:
      return rows(infrared_omni, angle);
    case 3:
      return rows(charging_state, battery_capacity);
    case 4:
      return rows(wall_signal, charger_available);
    case 5:
      return rows(oi_mode, requested_left_velocity);
    case 6:
      return rows(bumps_and_wheel_drops, requested_left_velocity);
    case 100:
      return rows(bumps_and_wheel_drops, stasis);
    case 101:
      return rows(left_encoder_counts, stasis);
    case 106:
      return rows(light_bump_left_signal, light_bump_right_signal);
    case 107:
      return rows(left_motor_current, stasis);
    default:
      return {};
  }
}

std::int32_t decode_value(const PacketInfo& packet, std::span<const std::uint8_t> bytes) {
  assert(bytes.size() == packet.bytes);
  if (packet.bytes == 1) {
    return packet.is_signed ? static_cast<std::int8_t>(bytes[0]) : static_cast<std::int32_t>(bytes[0]);
  }
  const auto word = static_cast<std::uint16_t>((bytes[0] << 8U) | bytes[1]);
  return packet.is_signed ? static_cast<std::int16_t>(word) : static_cast<std::int32_t>(word);
}

void encode_value(const PacketInfo& packet, std::int32_t value, std::span<std::uint8_t> bytes) {
  assert(bytes.size() == packet.bytes);
  const auto word = static_cast<std::uint32_t>(value);
  if (packet.bytes == 2) bytes[0] = static_cast<std::uint8_t>(word >> 8U);
  bytes[packet.bytes - 1U] = static_cast<std::uint8_t>(word);
}

}  // namespace wheelwright::open_interface

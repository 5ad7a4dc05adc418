#include "drivers/open_interface/reading.hpp"

namespace wheelwright::open_interface {
namespace {

using enum PacketId;

constexpr std::array asked{
    bumps_and_wheel_drops,
    cliff_left,
    cliff_front_left,
    cliff_front_right,
    cliff_right,
    overcurrents,
    charging_state,
    current,
    charger_available,
    left_encoder_counts,
    right_encoder_counts,
    light_bump_left_signal,
    light_bump_front_left_signal,
    light_bump_center_left_signal,
    light_bump_center_right_signal,
    light_bump_front_right_signal,
    light_bump_right_signal,
    left_motor_current,
    right_motor_current,
};

}  // namespace

std::span<const PacketId> reading_packets() {
  return asked;
}

bool put(Reading& reading, const PacketInfo& packet, std::int32_t value) {
  if (value < packet.minimum || value > packet.maximum) return false;
  const auto byte = static_cast<std::uint8_t>(value);
  switch (packet.id) {
    case bumps_and_wheel_drops:
      reading.bumps_and_wheel_drops = byte;
      break;
    case cliff_left:
    case cliff_front_left:
    case cliff_front_right:
    case cliff_right:
      reading.cliff = reading.cliff || value != 0;
      break;
    case overcurrents:
      reading.overcurrents = byte;
      break;
    case charging_state:
      reading.charging_state = byte;
      break;
    case charger_available:
      reading.charger_available = byte;
      break;
    case oi_mode:
      reading.oi_mode = byte;
      break;
    case voltage:
      if (value < lowest_voltage_mv || value > highest_voltage_mv) return false;
      reading.voltage_mv = value;
      break;
    case current:
      reading.current_ma = value;
      break;
    case left_encoder_counts:
      reading.left_counts = static_cast<std::uint16_t>(value);
      break;
    case right_encoder_counts:
      reading.right_counts = static_cast<std::uint16_t>(value);
      break;
    case left_motor_current:
      reading.left_motor_ma = value;
      break;
    case right_motor_current:
      reading.right_motor_ma = value;
      break;
    default:
      if (packet.id >= light_bump_left_signal && packet.id <= light_bump_right_signal) {
        const auto at =
            static_cast<std::size_t>(packet.id) - static_cast<std::size_t>(light_bump_left_signal);
        reading.light_bumper.at(at) = static_cast<std::uint16_t>(value);
      }
  }
  return true;
}

}  // namespace wheelwright::open_interface

#include "drivers/simulation/sensor_board.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wheelwright::simulation {
namespace {

using open_interface::PacketId;

// What the firmware takes its own wheels for (Create 2 Open Interface pages 5 and 31).
constexpr double nominal_wheel_diameter_mm = 72.0;
constexpr double nominal_wheel_base_mm = 235.0;
// The bumper is split in the middle; a hit within this angle presses both halves.
constexpr double both_bumpers_rad = 0.2;
constexpr double stall_current_a = 1.2;
constexpr std::int32_t floor_signal = 2600;  // of a cliff sensor over a light floor

std::int32_t rounded(double value) {
  return static_cast<std::int32_t>(std::lround(value));
}

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

}  // namespace

SensorBoard::SensorBoard(const SimulationConfig& config)
    : encoder_(config.encoder),
      battery_(config.battery),
      light_bumper_(config.light_bumper),
      last_left_(config.encoder.start_count_left),
      last_right_(config.encoder.start_count_right) {}

void SensorBoard::refresh(const Mechanics& mechanics, bool charger_connected, Noise& noise) {
  refresh_contacts(mechanics);
  refresh_odometry(mechanics);
  refresh_power(mechanics, charger_connected, noise);
  refresh_light_bumper(mechanics, noise);
  set(PacketId::stasis, mechanics.chassis().forward_speed_m_s() > 0.005 ? 1 : 0);
}

void SensorBoard::refresh_contacts(const Mechanics& mechanics) {
  const Chassis& body = mechanics.chassis();
  std::int32_t bits = 0;
  const double bearing_rad = body.touch_bearing_rad();
  if (body.touches() && std::abs(bearing_rad) < 0.5 * std::numbers::pi) {
    if (bearing_rad < both_bumpers_rad) bits |= 1;
    if (bearing_rad > -both_bumpers_rad) bits |= 2;
  }
  if (mechanics.hangs(Side::right)) bits |= 4;
  if (mechanics.hangs(Side::left)) bits |= 8;
  set(PacketId::bumps_and_wheel_drops, bits);

  constexpr std::array<double, 4> cliff_bearing_rad{1.05, 0.26, -0.26, -1.05};
  constexpr double cliff_radius_m = 0.15;
  for (std::size_t i = 0; i < cliff_bearing_rad.size(); ++i) {
    const Point at = body.in_room(cliff_radius_m * std::cos(cliff_bearing_rad[i]),
                                  cliff_radius_m * std::sin(cliff_bearing_rad[i]));
    const bool cliff = mechanics.room().has_cliffs() && mechanics.room().is_cliff(at);
    values_[index(PacketId::cliff_left) + i] = cliff ? 1 : 0;
    values_[index(PacketId::cliff_left_signal) + i] = cliff ? 5 : floor_signal;
  }
}

void SensorBoard::refresh_odometry(const Mechanics& mechanics) {
  const Encoder& left = mechanics.left().encoder;
  const Encoder& right = mechanics.right().encoder;
  set(PacketId::left_encoder_counts, (encoder_.swap_sides ? right : left).reading());
  set(PacketId::right_encoder_counts, (encoder_.swap_sides ? left : right).reading());

  const double mm_per_count = std::numbers::pi * nominal_wheel_diameter_mm / encoder_.counts_per_revolution;
  const double left_mm = mm_per_count * static_cast<double>(left.unwrapped() - last_left_);
  const double right_mm = mm_per_count * static_cast<double>(right.unwrapped() - last_right_);
  last_left_ = left.unwrapped();
  last_right_ = right.unwrapped();
  distance_mm_ += 0.5 * (left_mm + right_mm);
  angle_deg_ += degrees((right_mm - left_mm) / nominal_wheel_base_mm);
  set(PacketId::distance, static_cast<std::int32_t>(std::clamp(distance_mm_, -32768.0, 32767.0)));
  set(PacketId::angle, static_cast<std::int32_t>(std::clamp(angle_deg_, -32768.0, 32767.0)));
}

void SensorBoard::asked_for(PacketId id) {
  if (id == PacketId::distance) distance_mm_ -= value(id);
  if (id == PacketId::angle) angle_deg_ -= value(id);
  if (id == PacketId::distance || id == PacketId::angle) set(id, 0);
}

void SensorBoard::refresh_power(const Mechanics& mechanics, bool charger_connected, Noise& noise) {
  const Battery& battery = mechanics.battery();
  double voltage_v = battery.voltage_v();
  if (battery_.voltage_noise_v > 0.0) voltage_v += battery_.voltage_noise_v * noise.normal();
  set(PacketId::voltage, std::clamp(rounded(1000.0 * voltage_v), 0, 65535));
  set(PacketId::current, std::clamp(rounded(-1000.0 * battery.current_a()), -32768, 32767));
  set(PacketId::temperature, rounded(battery_.temperature_c));
  set(PacketId::battery_charge, rounded(battery.charge_mah()));
  set(PacketId::battery_capacity, rounded(battery.capacity_mah()));
  constexpr std::int32_t full_charging = 2;
  constexpr std::int32_t internal_charger = 1;
  set(PacketId::charging_state, charger_connected ? full_charging : 0);
  set(PacketId::charger_available, charger_connected ? internal_charger : 0);

  const double left_a = mechanics.left().unit.current_a();
  const double right_a = mechanics.right().unit.current_a();
  set(PacketId::left_motor_current, rounded(1000.0 * left_a));
  set(PacketId::right_motor_current, rounded(1000.0 * right_a));
  set(PacketId::overcurrents,
      (std::abs(right_a) > stall_current_a ? 8 : 0) | (std::abs(left_a) > stall_current_a ? 16 : 0));
}

void SensorBoard::refresh_light_bumper(const Mechanics& mechanics, Noise& noise) {
  const auto signals = light_bumper_.look(mechanics.chassis(), mechanics.room(), noise);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    values_[index(PacketId::light_bump_left_signal) + i] = signals[i];
  }
  set(PacketId::light_bumper, light_bumper_.bits(signals));
  set(PacketId::wall_signal, signals.back());
  set(PacketId::wall, (value(PacketId::light_bumper) >> 5) & 1);
}

bool SensorBoard::any_cliff() const {
  return value(PacketId::cliff_left) + value(PacketId::cliff_front_left) +
             value(PacketId::cliff_front_right) + value(PacketId::cliff_right) >
         0;
}

bool SensorBoard::any_wheel_drop() const {
  return (value(PacketId::bumps_and_wheel_drops) & 12) != 0;
}

}  // namespace wheelwright::simulation

// What a robot would put on the wire: sensor values, replies and stream frames, and what happens to them.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "drivers/open_interface/packets.hpp"
#include "drivers/open_interface/reading.hpp"
#include "drivers/open_interface/stream_reader.hpp"

namespace wheelwright::open_interface {

using Bytes = std::vector<std::uint8_t>;
using Random = std::mt19937_64;

inline int between(Random& random, int lowest, int highest) {
  return std::uniform_int_distribution<int>(lowest, highest)(random);
}

inline std::uint8_t any_byte(Random& random) {
  return static_cast<std::uint8_t>(between(random, 0, 255));
}

// One value per packet, by its number.
struct SensorValues {
  std::array<int, 59> by_id{};

  int& operator[](PacketId id) { return by_id.at(static_cast<std::size_t>(id)); }
  int operator[](PacketId id) const { return by_id.at(static_cast<std::size_t>(id)); }
};

// A robot that drives about: mostly nothing touched, currents and signals of any size.
inline SensorValues driving_robot(Random& random) {
  using enum PacketId;
  SensorValues values;
  values[voltage] = between(random, 12000, 17000);
  values[oi_mode] = between(random, 1, 3);
  values[bumps_and_wheel_drops] = between(random, 0, 3) == 0 ? between(random, 0, 15) : 0;
  values[cliff_front_left] = between(random, 0, 9) == 0 ? 1 : 0;
  values[overcurrents] = between(random, 0, 9) == 0 ? 8 : 0;
  values[current] = between(random, -3000, 500);
  values[left_encoder_counts] = between(random, -32768, 32767);
  values[right_encoder_counts] = between(random, -32768, 32767);
  for (auto id = static_cast<std::size_t>(light_bump_left_signal); id <= 51; ++id) {
    values.by_id.at(id) = between(random, 0, 1) == 0 ? between(random, 0, 30) : between(random, 0, 4095);
  }
  values[left_motor_current] = between(random, -300, 1200);
  values[right_motor_current] = between(random, -300, 1200);
  return values;
}

// Big-endian, 16 bits where the specification has 16: written out here so as not to test code with itself.
inline void append_packet(Bytes& bytes, PacketId id, int value) {
  const auto number = static_cast<int>(id);
  const bool is_word = (number >= 19 && number <= 20) || (number >= 22 && number <= 23) ||
                       (number >= 25 && number <= 31) || number == 33 || (number >= 39 && number <= 44) ||
                       (number >= 46 && number <= 51) || (number >= 54 && number <= 57);
  const auto word = static_cast<unsigned>(value);
  if (is_word) bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(word));
}

inline Bytes reply_to(std::span<const PacketId> packets, const SensorValues& values) {
  Bytes bytes;
  for (const PacketId id : packets) append_packet(bytes, id, values[id]);
  return bytes;
}

inline Bytes stream_frame(std::span<const PacketId> packets, const SensorValues& values, ChecksumRule rule) {
  Bytes bytes{19, 0};
  for (const PacketId id : packets) {
    bytes.push_back(static_cast<std::uint8_t>(id));
    append_packet(bytes, id, values[id]);
  }
  bytes[1] = static_cast<std::uint8_t>(bytes.size() - 2);
  unsigned sum = 0;
  for (std::size_t i = rule == ChecksumRule::header_excluded ? 1 : 0; i < bytes.size(); ++i) sum += bytes[i];
  bytes.push_back(static_cast<std::uint8_t>(0U - sum));
  return bytes;
}

inline bool says(const Reading& reading, const SensorValues& values) {
  using enum PacketId;
  bool same = reading.bumps_and_wheel_drops == values[bumps_and_wheel_drops] &&
              reading.cliff == ((values[cliff_left] | values[cliff_front_left] | values[cliff_front_right] |
                                 values[cliff_right]) != 0) &&
              reading.overcurrents == values[overcurrents] && reading.oi_mode == values[oi_mode] &&
              reading.charging_state == values[charging_state] &&
              reading.charger_available == values[charger_available] &&
              reading.voltage_mv == values[voltage] && reading.current_ma == values[current] &&
              reading.left_counts == static_cast<std::uint16_t>(values[left_encoder_counts]) &&
              reading.right_counts == static_cast<std::uint16_t>(values[right_encoder_counts]) &&
              reading.left_motor_ma == values[left_motor_current] &&
              reading.right_motor_ma == values[right_motor_current];
  for (std::size_t i = 0; i < 6; ++i) same = same && reading.light_bumper.at(i) == values.by_id.at(46 + i);
  return same;
}

inline Bytes noise(Random& random, int length) {
  Bytes bytes;
  for (int i = 0; i < length; ++i) bytes.push_back(any_byte(random));
  return bytes;
}

inline Bytes text(std::string_view letters) {
  return {letters.begin(), letters.end()};
}

inline void append(Bytes& bytes, const Bytes& more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

inline void insert_at(Bytes& bytes, int position, const Bytes& more) {
  bytes.insert(bytes.begin() + position, more.begin(), more.end());
}

}  // namespace wheelwright::open_interface

// A RoombaLink on a table: the test says what the robot answers, and sees every byte that is written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/roomba/roomba_link.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"

namespace wheelwright::roomba {

using open_interface::Bytes;
using open_interface::PacketId;
using open_interface::SensorValues;

inline const Bytes drive_zeros{145, 0, 0, 0, 0};

inline SensorValues resting_robot(int mode) {
  SensorValues values;
  values[PacketId::voltage] = 15000;
  values[PacketId::oi_mode] = mode;
  return values;
}

inline bool contains(const Bytes& bytes, const Bytes& part) {
  return std::search(bytes.begin(), bytes.end(), part.begin(), part.end()) != bytes.end();
}

// A link whose robot says whatever the test wants.
class Bench {
 public:
  explicit Bench(const LinkConfig& config = {}) : link(config) { link.port_opened(); }

  // One tick; the robot answers with `says`, or not at all.
  SensorFrame tick(const std::optional<Command>& command, bool answers = true) {
    written = begin(command);
    if (!answers) return complete(nullptr);
    const auto list = asked_for();
    if (list.empty()) return complete(nullptr);
    std::optional<open_interface::Reading> reading;
    for (const std::uint8_t byte : reply_to(list, says)) {
      if (const auto whole = link.receive(byte)) reading = whole;
    }
    return complete(reading ? &*reading : nullptr);
  }

  SensorFrame drive(double left_m_s, double right_m_s, bool answers = true) {
    Command command;
    command.speed_m_s = {left_m_s, right_m_s};
    return tick(command, answers);
  }

  void start() {
    says = resting_robot(1);
    while (link.state() != LinkState::running) tick(std::nullopt);
    link.arm();
    says[PacketId::oi_mode] = 2;
    drive(0.0, 0.0);
  }

  RoombaLink link;
  SensorValues says = resting_robot(1);
  Bytes written;  // at the beginning of the last tick
  Bytes urgent;   // and right after its reading

 private:
  Bytes begin(const std::optional<Command>& command) {
    const auto bytes = link.begin_tick(tick_++, 0.0, command);
    return {bytes.begin(), bytes.end()};
  }

  // The query list is the last command of a tick.
  std::vector<PacketId> asked_for() const {
    const auto count = link.reply_counts().asked > asked_before_ ? packets_in_list : 0;
    std::vector<PacketId> list;
    for (std::size_t i = written.size() - count; i < written.size(); ++i) {
      list.push_back(static_cast<PacketId>(written.at(i)));
    }
    return list;
  }

  SensorFrame complete(const open_interface::Reading* reading) {
    asked_before_ = link.reply_counts().asked;
    const SensorFrame frame = link.complete_tick(reading);
    const auto bytes = link.urgent_bytes();
    urgent.assign(bytes.begin(), bytes.end());
    return frame;
  }

  static constexpr std::size_t packets_in_list = 23;
  std::int64_t tick_ = 0;
  std::uint64_t asked_before_ = 0;
};

// Whether the bytes of one tick hold a drive command other than zeros. Opcodes are known by position: what
// the link writes is start, mode, drive and query, in this order.
inline bool moves(const Bytes& bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const std::uint8_t opcode = bytes[i];
    if (opcode == 145 || opcode == 146) {
      if (Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                bytes.begin() + static_cast<std::ptrdiff_t>(i) + 5) != Bytes(4, 0)) {
        return true;
      }
      i += 5;
    } else if (opcode == 148 || opcode == 149) {
      i += 2U + bytes.at(i + 1);
    } else if (opcode == 150) {
      i += 2;
    } else {
      ++i;
    }
  }
  return false;
}

}  // namespace wheelwright::roomba

// Commands of the Open Interface as bytes. Pure; a command is written whole in one go, since the robot waits
// without a time-out for the rest of a half-sent one (Roomba 500 Open Interface, page 6).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drivers/open_interface/packets.hpp"

namespace wheelwright::open_interface {

// A few commands in a row, in memory of their own.
class CommandBytes {
 public:
  std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }
  void clear() { size_ = 0; }

  void start();      // 128, to Passive
  void safe_mode();  // 131
  void full_mode();  // 132
  void stop_oi();    // 173, back to Off; not in the 500 specification, ignored there
  // Speeds of the wheels in mm/s, -500 to 500; the robot's own speed controller is on (145).
  void drive_direct(int right_mm_s, int left_mm_s);
  // Duty of the wheel motors, -255 to 255; the speed controller is off (146).
  void drive_pwm(int right, int left);
  // Asks for packets once (149); the reply is their bare data in this order.
  void query_list(std::span<const PacketId> packets);
  // Asks for packets again and again, in frames (148).
  void stream(std::span<const PacketId> packets);
  void pause_stream();  // 150 0
  // Zeros end a half-sent command without moving anything: as data they are speed zero, as opcodes nothing.
  void padding(std::size_t count);

 private:
  void add(std::uint8_t byte);
  void add_word(int value);

  std::array<std::uint8_t, 256> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace wheelwright::open_interface

#include "drivers/open_interface/commands.hpp"

#include <algorithm>
#include <stdexcept>

namespace wheelwright::open_interface {

void CommandBytes::add(std::uint8_t byte) {
  if (size_ == bytes_.size()) throw std::length_error("more Open Interface commands than fit one write");
  bytes_[size_++] = byte;
}

void CommandBytes::add_word(int value) {
  const auto word = static_cast<std::uint16_t>(static_cast<std::int16_t>(value));
  add(static_cast<std::uint8_t>(word >> 8U));
  add(static_cast<std::uint8_t>(word & 0xFFU));
}

void CommandBytes::start() {
  add(128);
}

void CommandBytes::safe_mode() {
  add(131);
}

void CommandBytes::full_mode() {
  add(132);
}

void CommandBytes::stop_oi() {
  add(173);
}

void CommandBytes::drive_direct(int right_mm_s, int left_mm_s) {
  constexpr int limit = 500;
  add(145);
  add_word(std::clamp(right_mm_s, -limit, limit));
  add_word(std::clamp(left_mm_s, -limit, limit));
}

void CommandBytes::drive_pwm(int right, int left) {
  constexpr int limit = 255;
  add(146);
  add_word(std::clamp(right, -limit, limit));
  add_word(std::clamp(left, -limit, limit));
}

void CommandBytes::query_list(std::span<const PacketId> packets) {
  add(149);
  add(static_cast<std::uint8_t>(packets.size()));
  for (const PacketId id : packets) add(static_cast<std::uint8_t>(id));
}

void CommandBytes::stream(std::span<const PacketId> packets) {
  add(148);
  add(static_cast<std::uint8_t>(packets.size()));
  for (const PacketId id : packets) add(static_cast<std::uint8_t>(id));
}

void CommandBytes::pause_stream() {
  add(150);
  add(0);
}

void CommandBytes::padding(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) add(0);
}

}  // namespace wheelwright::open_interface

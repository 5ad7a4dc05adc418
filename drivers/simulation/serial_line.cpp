#include "drivers/simulation/serial_line.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::simulation {
namespace {

Nanoseconds time_of_byte(int baud) {
  constexpr double bits = 10.0;  // start, eight data, stop
  return nanoseconds(bits / baud);
}

}  // namespace

Nanoseconds nanoseconds(double seconds) {
  return Nanoseconds(std::llround(seconds * 1e9));
}

SerialLine::SerialLine(Sender sender, int baud, std::size_t buffer, const ByteFaults& faults,
                       double latency_s)
    : sender_(sender),
      baud_(baud),
      byte_time_(time_of_byte(baud)),
      buffer_(std::min(buffer, capacity)),
      faults_(faults),
      latency_(nanoseconds(latency_s)) {}

void SerialLine::set_baud(int baud) {
  baud_ = baud;
  settle_byte_time();
}

void SerialLine::set_host_baud(int baud) {
  host_baud_ = baud;
  settle_byte_time();
}

void SerialLine::settle_byte_time() {
  byte_time_ = time_of_byte(sender_ == Sender::host && host_baud_ != 0 ? host_baud_ : baud_);
}

void SerialLine::send(std::uint8_t byte, Nanoseconds now, Noise& noise) {
  const Nanoseconds start = std::max(now, free_at_);
  const bool buffer_full = start - now >= byte_time_ * static_cast<std::int64_t>(buffer_);
  if (buffer_full || count_ == capacity) return;
  free_at_ = start + byte_time_;
  if (noise.happens(faults_.loss_probability)) return;
  if (noise.happens(faults_.bit_flip_probability)) {
    byte = static_cast<std::uint8_t>(byte ^ (1U << (noise.bits() % 8U)));
  }
  if (host_baud_ != 0 && host_baud_ != baud_) byte = static_cast<std::uint8_t>(noise.bits());
  ring_[(first_ + count_) % capacity] = {free_at_ + latency_, byte};
  ++count_;
}

std::optional<SerialLine::Arrival> SerialLine::front() const {
  if (count_ == 0) return std::nullopt;
  return ring_[first_];
}

void SerialLine::pop() {
  first_ = (first_ + 1) % capacity;
  --count_;
}

void SerialLine::clear(Nanoseconds now) {
  first_ = 0;
  count_ = 0;
  free_at_ = now;
}

Receiver::Receiver(double latency_timer_s, int chunk_bytes)
    : timer_(nanoseconds(latency_timer_s)), chunk_(static_cast<std::size_t>(std::max(1, chunk_bytes))) {}

std::size_t Receiver::readable(const SerialLine& line, Nanoseconds now) {
  std::size_t arrived = released_;
  while (arrived < line.under_way() && line.at(arrived).at <= now) ++arrived;
  if (timer_ == Nanoseconds::zero()) return released_ = arrived;
  while (released_ < arrived) {
    const std::size_t full = released_ + chunk_;
    const Nanoseconds fires = (line.at(released_).at / timer_ + 1) * timer_;
    const bool full_before_timer = full <= arrived && line.at(full - 1).at <= fires;
    if (!full_before_timer && fires > now) break;
    if (full_before_timer) {
      released_ = full;
    } else {
      while (released_ < arrived && line.at(released_).at <= fires) ++released_;
    }
  }
  return released_;
}

}  // namespace wheelwright::simulation

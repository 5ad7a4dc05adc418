// One direction of the cable: bytes leave one after the other at the line's speed and arrive later, perhaps
// damaged, lost, or held back by a USB converter.
//
// Time is virtual, in nanoseconds since the robot was switched on. The memory is fixed: a sender that gets
// further ahead of the line than the sending end can buffer loses bytes, as a UART does.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drivers/simulation/noise.hpp"
#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

using Nanoseconds = std::chrono::nanoseconds;

Nanoseconds nanoseconds(double seconds);

class SerialLine {
 public:
  struct Arrival {
    Nanoseconds at;
    std::uint8_t byte;
  };
  static constexpr std::size_t capacity = 8192;

  enum class Sender { host, robot };

  // At most `buffer` bytes wait to be sent; `buffer` is no more than `capacity`.
  SerialLine(Sender sender, int baud, std::size_t buffer, const ByteFaults& faults, double latency_s);

  // The robot's speed. Once the host's is known too and differs, every byte arrives as a random one. Bytes
  // take the time that their sender's speed gives them.
  void set_baud(int baud);
  int baud() const { return baud_; }
  void set_host_baud(int baud);
  void send(std::uint8_t byte, Nanoseconds now, Noise& noise);
  // The next byte, whenever it arrives; nothing if none is under way.
  std::optional<Arrival> front() const;
  void pop();
  void clear(Nanoseconds now);
  std::size_t under_way() const { return count_; }
  const Arrival& at(std::size_t index) const { return ring_[(first_ + index) % capacity]; }

 private:
  void settle_byte_time();

  Sender sender_;
  int baud_;
  int host_baud_ = 0;  // 0: the same
  Nanoseconds byte_time_;
  std::size_t buffer_;
  ByteFaults faults_;
  Nanoseconds latency_;
  Nanoseconds free_at_{0};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::array<Arrival, capacity> ring_{};
};

// The far end of a line: a plain UART, or an FTDI converter that hands on bytes only when its timer fires or
// a packet is full.
class Receiver {
 public:
  Receiver(double latency_timer_s, int chunk_bytes);

  // How many bytes of the line can be read at `now`.
  std::size_t readable(const SerialLine& line, Nanoseconds now);
  void taken(std::size_t bytes) { released_ -= bytes; }
  void reset() { released_ = 0; }

 private:
  Nanoseconds timer_;
  std::size_t chunk_;
  std::size_t released_ = 0;
};

}  // namespace wheelwright::simulation

// A cable between host and robot on which things go wrong, in both directions, on whatever clock the caller
// has: bytes are put in at a time and taken out at a time, and times only rise.
//
//   FaultyCable cable({.seed = 7});
//   cable.put(Direction::to_robot, bytes, now);
//   const std::size_t count = cable.take(Direction::to_robot, buffer, now);
//   while (const auto done = cable.next_finished()) note(*done);
//
// Without a fault all bytes come out at the time at which they went in. It does not know the line's speed:
// the simulated robot's own line (serial_line.hpp) takes care of that.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "drivers/simulation/cable_fault.hpp"
#include "drivers/simulation/noise.hpp"

namespace wheelwright::simulation {

enum class Direction : std::uint8_t { to_robot, to_host };

// A fault that is over, and what it did.
struct CableFaultRecord {
  CableFault fault;
  std::int64_t bytes_passed = 0;  // of those in its directions while it lasted, unharmed and in time
  std::int64_t bytes_hit = 0;     // lost, changed, doubled or held back
  std::int64_t bytes_added = 0;   // that nobody sent
};

class FaultyCable {
 public:
  explicit FaultyCable(const CableFaultConfig& config);

  void put(Direction direction, std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now);
  // Takes what has arrived by now; returns how many bytes were written to `out`.
  std::size_t take(Direction direction, std::span<std::uint8_t> out, std::chrono::nanoseconds now);

  // False while the cable is out; what is put in then is lost.
  bool connected(std::chrono::nanoseconds now);
  // The fault that is at work, if there is one.
  std::optional<CableFault> active(std::chrono::nanoseconds now);
  // The faults that are over, in order, each of them once.
  std::optional<CableFaultRecord> next_finished();
  // No further fault begins; one that is at work goes on to its end.
  void let_be() { quiet_ = true; }

 private:
  struct OnTheWay {
    std::chrono::nanoseconds due;
    std::uint8_t byte;
  };
  struct Lane {
    std::deque<OnTheWay> bytes;
    std::chrono::nanoseconds last_put{0};  // what comes after a pause is a new packet
    std::int64_t passed_of_packet = 0;
    bool cut = false;  // the packet that is under way
  };

  void move_on(std::chrono::nanoseconds now);
  void begin(std::chrono::nanoseconds now);
  void end();
  bool hits(Direction direction) const;
  void put_byte(Lane& lane, Direction direction, std::uint8_t byte, std::chrono::nanoseconds now);
  void spoil(Lane& lane, Direction direction, std::uint8_t byte, std::chrono::nanoseconds now);
  void read_at_wrong_speed(Lane& lane, Direction direction, std::uint8_t byte, std::chrono::nanoseconds now);
  void add_noise(std::chrono::nanoseconds now);
  void append(Lane& lane, std::uint8_t byte, std::chrono::nanoseconds due);
  Lane& lane(Direction direction) { return direction == Direction::to_robot ? to_robot_ : to_host_; }

  CableFaultSequence sequence_;
  Noise noise_;
  CableFault next_;
  CableFaultRecord record_;  // of the fault that is at work
  bool at_work_ = false;
  bool quiet_ = false;
  std::chrono::nanoseconds noise_until_{0};  // for which noise has been made
  std::chrono::nanoseconds piece_delay_{0};  // of the piece that is being put in
  Lane to_robot_;
  Lane to_host_;
  std::deque<CableFaultRecord> finished_;
};

}  // namespace wheelwright::simulation

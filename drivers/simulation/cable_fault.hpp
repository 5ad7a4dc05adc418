// What goes wrong on a serial cable and its converter, one fault after the other, drawn from a seed.
//
// The same seed gives the same faults at the same times, whatever travels over the cable.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "drivers/simulation/noise.hpp"

namespace wheelwright::simulation {

enum class CableFaultKind : std::uint8_t {
  delay,        // everything arrives later by the same time
  jitter,       // everything arrives later, each piece by another time; order is kept
  drop,         // bytes are lost
  duplicate,    // bytes arrive twice
  flip,         // one bit of a byte is turned over
  burst,        // noise takes the place of the bytes, and comes where there are none
  freeze,       // nothing arrives; what was held back then comes at once
  half_packet,  // a packet ends in its middle
  wrong_baud,   // the host's end runs at another speed than the robot's
  disconnect,   // the cable is out: what is sent is lost, and the host's port is gone
};
inline constexpr int cable_fault_kinds = 10;
std::string_view name_of(CableFaultKind kind);
// By its name; nothing where there is none of that name.
std::optional<CableFaultKind> cable_fault_kind(std::string_view name);

struct CableFault {
  CableFaultKind kind{};
  bool to_robot = false;  // what the host sends is hit
  bool to_host = false;   // what the robot sends is hit
  std::chrono::nanoseconds from{0};
  std::chrono::nanoseconds until{0};
  // delay, jitter: seconds, at most. drop, duplicate, flip, burst: share of the bytes. half_packet: bytes
  // that still pass. wrong_baud: the host's speed over the robot's.
  double amount = 0.0;
};

struct CableFaultConfig {
  std::uint64_t seed = 1;
  std::vector<CableFaultKind> kinds = {};  // all, where empty
  double first_after_s = 2.0;
  double shortest_pause_s = 2.0;  // from the end of a fault to the next one
  double longest_pause_s = 4.0;
};

// An endless sequence of faults that do not overlap.
class CableFaultSequence {
 public:
  explicit CableFaultSequence(const CableFaultConfig& config);
  CableFault next();

 private:
  double between(double low, double high) { return low + (high - low) * noise_.uniform(); }
  // Small values as often as large ones.
  double log_between(double low, double high);
  void choose_directions(CableFault& fault);

  CableFaultConfig config_;
  Noise noise_;
  double next_at_s_;
};

}  // namespace wheelwright::simulation

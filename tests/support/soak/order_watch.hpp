// The commands in a stream of bytes to a robot, as far as they matter to a soak.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "drivers/simulation/command_parser.hpp"

namespace wheelwright::soak {

struct Orders {
  std::int64_t moving = 0;    // drive commands other than zeros
  std::int64_t standing = 0;  // zeros
  std::int64_t resets = 0;
  std::int64_t sleeps = 0;
  std::int64_t bauds = 0;      // the robot is told to talk at another speed
  std::int64_t cleanings = 0;  // cleaning and docking programs
  std::int64_t full_modes = 0;
};

class OrderWatch {
 public:
  void take(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      if (const auto command = parser_.feed(byte)) note(*command);
    }
  }
  const Orders& orders() const { return orders_; }

 private:
  void note(const simulation::HostCommand& command) {
    const auto is_zero = [](std::uint8_t byte) { return byte == 0; };
    switch (command.opcode) {
      case 137:
      case 145:
      case 146:
        ++(std::all_of(command.data.begin(), command.data.end(), is_zero) ? orders_.standing
                                                                          : orders_.moving);
        break;
      case 7:
        ++orders_.resets;
        break;
      case 133:
        ++orders_.sleeps;
        break;
      case 129:
        ++orders_.bauds;
        break;
      case 134:
      case 135:
      case 136:
      case 143:
        ++orders_.cleanings;
        break;
      case 132:
        ++orders_.full_modes;
        break;
      default:
        break;
    }
  }

  simulation::CommandParser parser_;
  Orders orders_;
};

}  // namespace wheelwright::soak

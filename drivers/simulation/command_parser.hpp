// Puts the bytes from the host together to commands, as the robot does: it waits for as many data bytes as
// the opcode has, without a time limit, so that a half-sent command swallows what follows (Roomba 500 Open
// Interface page 6). Bytes that are no opcode are passed over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace wheelwright::simulation {

struct HostCommand {
  std::uint8_t opcode;
  std::span<const std::uint8_t> data;  // valid until the next byte
};

class CommandParser {
 public:
  // The command that this byte completes, if it does.
  std::optional<HostCommand> feed(std::uint8_t byte);
  void reset() { length_ = 0; }

 private:
  std::array<std::uint8_t, 1024> bytes_{};  // longest: opcode 140 with 255 notes
  std::size_t length_ = 0;
};

}  // namespace wheelwright::simulation

#include "drivers/simulation/command_parser.hpp"

namespace wheelwright::simulation {
namespace {

// Data bytes of a command, as far as the bytes so far can tell, or nothing for what is no opcode.
std::optional<std::size_t> data_length(std::span<const std::uint8_t> command) {
  switch (command[0]) {
    case 7:
    case 128:
    case 130:
    case 131:
    case 132:
    case 133:
    case 134:
    case 135:
    case 136:
    case 143:
    case 173:
      return 0;
    case 129:
    case 138:
    case 141:
    case 142:
    case 150:
    case 165:
      return 1;
    case 162:
      return 2;
    case 139:
    case 144:
    case 168:
      return 3;
    case 137:
    case 145:
    case 146:
    case 163:
    case 164:
      return 4;
    case 167:
      return 15;
    case 140:
      return command.size() < 3 ? 2U : 2U + 2U * command[2];
    case 148:
    case 149:
      return command.size() < 2 ? 1U : 1U + command[1];
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<HostCommand> CommandParser::feed(std::uint8_t byte) {
  bytes_[length_] = byte;
  ++length_;
  const std::span<const std::uint8_t> command(bytes_.data(), length_);
  const std::optional<std::size_t> wanted = data_length(command);
  if (wanted && length_ < 1 + *wanted) return std::nullopt;
  length_ = 0;
  if (!wanted) return std::nullopt;
  return HostCommand{command[0], command.subspan(1)};
}

}  // namespace wheelwright::simulation

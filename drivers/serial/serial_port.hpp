// Opening a serial port (or a pseudo-terminal) for a robot.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <tl/expected.hpp>

namespace wheelwright::serial {

enum class PortErrorKind { missing, no_permission, in_use, not_a_port };

struct PortError {
  PortErrorKind kind;
  std::string message;  // one line: what, where, what would be right
};

struct OpenPort {
  int descriptor = -1;                  // raw, non-blocking, owned by the caller
  bool low_latency = false;             // the kernel took the low-latency flag
  std::optional<int> latency_timer_ms;  // of a USB adapter that has one, as read back
};

// Opens a port with 8 data bits, no parity, one stop bit, no flow control. The modem lines are left as they
// are when it is closed: moving them can reset a robot or change its baud rate. Takes an advisory lock
// (flock), which lasts until every duplicate of the descriptor is closed; a program that takes none, as a
// terminal, opens it all the same.
tl::expected<OpenPort, PortError> open_port(const std::filesystem::path& path, int baud);

// The error with what this machine knows of it: who has the port, or which ports there are. Looks through
// /proc and /dev: not for a loop that has to be on time.
std::string detailed_message(const PortError& error, const std::filesystem::path& path);

}  // namespace wheelwright::serial

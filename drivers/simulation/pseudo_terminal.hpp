// The robot's end of a pseudo-terminal: to programs its other end looks like a serial port.
//
// Clients may open, close and reopen that end at will; what is sent while none has it open is lost, as on a
// cable that nobody listens to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace wheelwright::simulation {

class PseudoTerminal {
 public:
  // Opens a terminal in raw mode at 115200 baud. Throws std::system_error where the system has none left.
  PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal();

  // The path that clients open, e.g. /dev/pts/7.
  const std::string& path() const { return path_; }

  // Takes what clients have sent; 0 where there is nothing. Never waits.
  std::size_t read(std::span<std::uint8_t> bytes);
  // What does not fit because no client reads is lost. Never waits.
  void write(std::span<const std::uint8_t> bytes);
  // The speed that the client has set, or nothing where no client is there or the speed is an odd one.
  std::optional<int> client_baud();

 private:
  bool client_is_there();

  int descriptor_ = -1;
  bool had_client_ = false;
  std::string path_;
};

// A symbolic link to the terminal for as long as this object lives.
class TerminalLink {
 public:
  // Replaces a symbolic link that leads nowhere any more, or to a terminal of this process; throws
  // std::runtime_error, one line, where it leads to anything else or is no link.
  TerminalLink(std::filesystem::path link, const std::string& target);
  TerminalLink(const TerminalLink&) = delete;
  TerminalLink& operator=(const TerminalLink&) = delete;
  ~TerminalLink();

 private:
  std::filesystem::path link_;
  std::string target_;
};

}  // namespace wheelwright::simulation

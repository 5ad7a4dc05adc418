// Who holds the robot's end of a pseudo-terminal.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

namespace wheelwright::simulation {

struct TerminalHolder {
  pid_t pid = 0;
  std::string name;  // of the program, as the system has it: its first 15 characters
};

// `terminal` is the other end's path, as /dev/pts/7. Nothing where no process that may be looked at holds it.
std::optional<TerminalHolder> holder_of(const std::filesystem::path& terminal);

}  // namespace wheelwright::simulation

// Which other programs have a serial port open, for a message that names them.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace wheelwright::serial {

struct PortHolder {
  pid_t pid = 0;
  std::string program;  // as the system has it: its first 15 characters
};

// All but this process. What another user runs is seen by root alone. A program that makes pseudo-terminals
// is taken for the far end of one, and left out there.
std::vector<PortHolder> other_holders(const std::filesystem::path& port);

// Who holds the lock of the port (flock), by /proc/locks; 0 where nobody does, or it cannot be known.
pid_t lock_owner(const std::filesystem::path& port);

// "minicom (process 4711) and screen (process 12)"; empty for nobody.
std::string names_of(const std::vector<PortHolder>& holders);

// "in use by minicom (process 4711); end it first", or that the holder cannot be seen.
std::string in_use_by(const std::filesystem::path& port);

}  // namespace wheelwright::serial

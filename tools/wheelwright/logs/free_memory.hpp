// Whether the logs that a command is given fit into memory, asked before they are read: a machine without
// free memory ends a program, or another one, without a word.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wheelwright::tools {

// Of this machine, without what it would have to swap; nothing where it does not say.
std::optional<std::uint64_t> free_memory_bytes();

// One line where drive logs of this size are too large for so much memory, with what would be right. A row
// of 50 characters takes 400 bytes, from its text to the motion that a model predicts for it.
std::optional<std::string> find_missing_memory(std::uint64_t logs_bytes, std::uint64_t free_bytes);

// The same of drive logs at these paths on this machine. Recordings of other formats are read in parts.
std::optional<std::string> find_missing_memory(const std::vector<std::string>& paths);

}  // namespace wheelwright::tools

// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace wheelwright::config {

// Writes beside `path`, syncs to the disk, and renames into place. Returns what went wrong, in one line, or
// nothing; after a failure the file that was at `path` before is untouched. A device or a pipe at `path` is
// written into as it is.
std::optional<std::string> write_file_atomically(const std::filesystem::path& path, const std::string& text);

}  // namespace wheelwright::config

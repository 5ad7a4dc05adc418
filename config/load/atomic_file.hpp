// Files that are there whole or not at all, in a folder of the program's own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace wheelwright::config {

// Writes beside `path`, syncs to the disk, and renames into place, by the rules of output_file.hpp but for
// the kind: whatever regular file is there is replaced. Returns what went wrong, in one line, or nothing;
// after a failure the file that was at `path` before is untouched. For a path that a person names use
// write_output.
std::optional<std::string> write_file_atomically(const std::filesystem::path& path, const std::string& text);

}  // namespace wheelwright::config

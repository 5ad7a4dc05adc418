// Files and folders that a command leaves.
#pragma once

#include <filesystem>
#include <string>

#include "config/load/output_file.hpp"

namespace wheelwright::tools {

// Throws UsageError where the file cannot be written, or may not be replaced (config::write_output).
void write(const config::OutputFile& file, const std::string& text);
void write(const std::filesystem::path& path, const std::string& text);

// With those that it lies in. Throws UsageError where it cannot be made.
void make_folder(const std::filesystem::path& path);

}  // namespace wheelwright::tools

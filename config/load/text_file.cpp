#include "config/load/text_file.hpp"

#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace wheelwright::config {

std::optional<std::string> read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::error_code ignored;
  if (!stream || std::filesystem::is_directory(path, ignored)) return std::nullopt;
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

std::string why_unreadable(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) return "is a folder, but must be a file";
  if (std::filesystem::exists(status)) return "cannot be read; do you have the permission?";
  return "cannot be read; does the file exist?";
}

}  // namespace wheelwright::config

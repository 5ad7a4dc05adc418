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

}  // namespace wheelwright::config

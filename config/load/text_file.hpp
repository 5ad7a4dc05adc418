// A whole file as text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace wheelwright::config {

// Nothing where the file cannot be read, or is a folder.
std::optional<std::string> read_text(const std::filesystem::path& path);

// Why a file cannot be read, and what would be right; without its name.
std::string why_unreadable(const std::filesystem::path& path);

// The text; throws Error, one line, where it cannot be read.
template <typename Error>
std::string read_text_or_throw(const std::filesystem::path& path) {
  auto text = read_text(path);
  if (!text) throw Error(path.string() + ": " + why_unreadable(path));
  return *std::move(text);
}

}  // namespace wheelwright::config

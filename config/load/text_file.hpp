// A whole file as text: read to its end or not at all, and never more of it than its kind may hold.
//
// A file is a regular file, one in /proc included, or a pipe that a shell made, as in <(zcat log.csv.gz) and
// /dev/stdin. Folders, devices, sockets and named pipes are refused before they are opened: opening a device
// may do something to it, and a named pipe may never end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace wheelwright::config {

struct FileKind {
  std::string_view name;  // with its article
  std::uint64_t max_bytes;
};
inline constexpr FileKind yaml_file{"a YAML file", 8U << 20U};
inline constexpr FileKind log_file{"a log", 1U << 30U};
inline constexpr FileKind record_file{"a file of results", 32U << 20U};

// The text, or one line that says which file cannot be read, why, and what would be right.
tl::expected<std::string, std::string> read_text(const std::filesystem::path& path, const FileKind& kind);

// The text; throws Error where it cannot be read.
template <typename Error>
std::string read_text_or_throw(const std::filesystem::path& path, const FileKind& kind) {
  auto text = read_text(path, kind);
  if (!text) throw Error(text.error());
  return *std::move(text);
}

}  // namespace wheelwright::config

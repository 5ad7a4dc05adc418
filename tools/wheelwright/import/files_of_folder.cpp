#include "tools/wheelwright/import/files_of_folder.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "config/load/ascii_text.hpp"

namespace wheelwright::import {
namespace {

namespace fs = std::filesystem;

bool has_suffix_of_text(const fs::path& path) {
  constexpr std::array<std::string_view, 6> suffixes{".csv", ".tsv", ".txt", ".log", ".dat", ".tum"};
  const std::string suffix = config::lower_case(path.extension().string());
  return std::ranges::find(suffixes, suffix) != suffixes.end();
}

bool is_of_bag(const fs::path& path) {
  constexpr std::array<std::string_view, 4> suffixes{".bag", ".mcap", ".db3", ".zstd"};
  const std::string suffix = config::lower_case(path.extension().string());
  return std::ranges::find(suffixes, suffix) != suffixes.end() || path.filename() == "metadata.yaml";
}

// Beside it the daemon writes what it computed from it.
bool is_drive_log_of_daemon(const fs::path& path) {
  return path.filename() == "drive_log.csv";
}

struct FolderContents {
  std::vector<fs::path> texts;
  bool has_bag = false;
};

FolderContents contents_of(const fs::path& folder) {
  FolderContents contents;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (!entry->is_regular_file(ignored) || entry->path().filename().string().starts_with('.')) continue;
    if (is_of_bag(entry->path())) contents.has_bag = true;
    if (has_suffix_of_text(entry->path())) contents.texts.push_back(entry->path());
  }
  std::ranges::sort(contents.texts);
  const auto drive_log = std::ranges::find_if(contents.texts, is_drive_log_of_daemon);
  if (drive_log != contents.texts.end()) contents.texts = {fs::path(*drive_log)};
  return contents;
}

}  // namespace

tl::expected<std::vector<ListedFile>, std::string> files_of_folders(const std::vector<fs::path>& paths) {
  constexpr std::size_t most_files = 32;
  std::vector<ListedFile> files;
  for (const fs::path& path : paths) {
    std::error_code error;
    FolderContents contents = fs::is_directory(path, error) ? contents_of(path) : FolderContents{{}, true};
    if (contents.has_bag || contents.texts.empty()) {
      files.push_back({path});
      continue;
    }
    if (contents.texts.size() > most_files)
      return tl::unexpected(path.string() + ": holds " + std::to_string(contents.texts.size()) +
                            " text files; name those of one robot");
    for (fs::path& text : contents.texts) files.push_back({std::move(text), false});
  }
  return files;
}

}  // namespace wheelwright::import

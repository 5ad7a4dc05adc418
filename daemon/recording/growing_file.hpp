// A file that grows piece by piece and loses at most a second on a power cut.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace wheelwright::daemon {

class GrowingFile {
 public:
  GrowingFile() = default;
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  // Creates the file, which may not be there yet, with its head (for a CSV: metadata and header row). False
  // where that fails; error() then says why.
  bool create(const std::filesystem::path& path, const std::string& head);
  bool is_open() const { return descriptor_ >= 0; }

  // Adds a piece, whole or not at all. What cannot be written (disk full) is tried again; meanwhile pieces
  // beyond what memory is set aside for are refused.
  bool add(std::string_view piece);
  // Adds one line, without its line end; one that is refused is counted as lost.
  void add_line(const std::string& line);

  // Hands what was added to the disk. Call it several times a second.
  void flush(std::chrono::steady_clock::time_point now);
  // Of lines that the disk does not take any more, none is left there in part.
  void close();

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t lost_lines() const { return lost_lines_; }
  const std::optional<std::string>& error() const { return error_; }  // the first that occurred

 private:
  bool write_pending();
  void leave_out_cut_line();

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::string pending_;
  std::chrono::steady_clock::time_point next_sync_{};
  std::int64_t written_bytes_ = 0;
  std::int64_t whole_lines_bytes_ = 0;
  bool holds_lines_ = false;
  std::uint64_t lost_lines_ = 0;
  std::optional<std::string> error_;
};

}  // namespace wheelwright::daemon

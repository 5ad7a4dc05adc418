#include "daemon/recording/growing_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace wheelwright::daemon {
namespace {

constexpr std::size_t max_pending_bytes = 1UL << 20U;  // about a minute of ticks
constexpr auto sync_every = std::chrono::milliseconds(500);

}  // namespace

GrowingFile::~GrowingFile() {
  close();
}

bool GrowingFile::create(const std::filesystem::path& path, const std::string& head) {
  path_ = path;
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (descriptor_ < 0) {
    error_ = path.string() + ": cannot be created: " + std::strerror(errno);
    return false;
  }
  pending_ = head;
  write_pending();
  return true;
}

bool GrowingFile::add(std::string_view piece) {
  if (descriptor_ < 0 || pending_.size() + piece.size() > max_pending_bytes) return false;
  pending_ += piece;
  return true;
}

void GrowingFile::add_line(const std::string& line) {
  holds_lines_ = true;
  if (!add(line + '\n')) ++lost_lines_;
}

bool GrowingFile::write_pending() {
  while (!pending_.empty()) {
    const ssize_t written = ::write(descriptor_, pending_.data(), pending_.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      if (!error_) error_ = path_.string() + ": cannot be written: " + std::strerror(errno);
      return false;
    }
    const auto end = pending_.rfind('\n', static_cast<std::size_t>(written) - 1);
    if (end != std::string::npos) whole_lines_bytes_ = written_bytes_ + static_cast<std::int64_t>(end) + 1;
    written_bytes_ += written;
    pending_.erase(0, static_cast<std::size_t>(written));
  }
  return true;
}

// Whoever reads it later would refuse a line that ends in the middle, and the file with it.
void GrowingFile::leave_out_cut_line() {
  lost_lines_ += static_cast<std::uint64_t>(std::count(pending_.begin(), pending_.end(), '\n'));
  pending_.clear();
  if (::ftruncate(descriptor_, whole_lines_bytes_) != 0 && !error_)
    error_ = path_.string() + ": ends in the middle of a line: " + std::strerror(errno);
}

void GrowingFile::flush(std::chrono::steady_clock::time_point now) {
  if (descriptor_ < 0 || now < next_sync_) return;
  next_sync_ = now + sync_every;
  if (write_pending()) ::fdatasync(descriptor_);
}

void GrowingFile::close() {
  if (descriptor_ < 0) return;
  if (!write_pending() && holds_lines_) leave_out_cut_line();
  ::fdatasync(descriptor_);
  ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace wheelwright::daemon

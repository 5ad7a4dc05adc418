#include "tools/wheelwright/import/formats/ros/storage/file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace wheelwright::import::ros {
namespace {

constexpr std::uint64_t smallest_window_bytes = 1U << 20U;

}  // namespace

tl::expected<FileBytes, std::string> FileBytes::open(const std::filesystem::path& path) {
  const auto refused = [&](const std::string& why) { return tl::unexpected(path.string() + ": " + why); };
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0) return refused(std::string("cannot be read: ") + std::strerror(errno));
  FileBytes file(descriptor, 0);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0)
    return refused(std::string("cannot be read: ") + std::strerror(errno));
  if (!S_ISREG(status.st_mode)) return refused("is not a regular file; save the recording to a file first");
  file.size_ = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
  return file;
}

FileBytes::FileBytes(FileBytes&& other) noexcept
    : memory_(other.memory_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      window_(std::move(other.window_)),
      window_offset_(other.window_offset_),
      window_bytes_(other.window_bytes_) {}

FileBytes::~FileBytes() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string_view FileBytes::view(std::uint64_t offset, std::uint64_t count) {
  count = std::min(count, left(offset));
  if (count == 0) return {};
  if (descriptor_ < 0) return memory_.substr(offset, count);
  if (offset < window_offset_ || offset - window_offset_ + count > window_bytes_) fill(offset, count);
  const std::uint64_t start = offset - window_offset_;
  return {window_.data() + start, static_cast<std::size_t>(std::min(count, window_bytes_ - start))};
}

void FileBytes::fill(std::uint64_t offset, std::uint64_t count) {
  const std::uint64_t wanted = std::min(std::max(count, smallest_window_bytes), left(offset));
  if (window_.size() < wanted) window_.resize(wanted);
  window_offset_ = offset;
  window_bytes_ = 0;
  while (window_bytes_ < wanted) {
    const ssize_t got = ::pread(descriptor_, window_.data() + window_bytes_, wanted - window_bytes_,
                                static_cast<off_t>(offset + window_bytes_));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;  // it became shorter, or the disk fails: what is there is read as a file cut short
    window_bytes_ += static_cast<std::uint64_t>(got);
  }
}

}  // namespace wheelwright::import::ros

#include "config/load/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace wheelwright::config {
namespace {

bool write_all(int descriptor, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = ::write(descriptor, text.data() + written, text.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    written += static_cast<std::size_t>(n);
  }
  return true;
}

// A device or a pipe stays what it is: a file in the place of /dev/null would spoil the machine.
std::optional<std::string> write_into(const std::filesystem::path& path, const std::string& text) {
  const auto failure = [&] { return path.string() + ": cannot be written: " + std::strerror(errno); };
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return failure();
  const bool written = write_all(descriptor, text);
  const int write_error = errno;
  ::close(descriptor);
  errno = write_error;
  return written ? std::nullopt : std::optional(failure());
}

}  // namespace

std::optional<std::string> write_file_atomically(const std::filesystem::path& path, const std::string& text) {
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  if (std::filesystem::is_other(status)) return write_into(path, text);
  const std::string temporary = path.string() + ".part";
  const auto failure = [&](const char* what) {
    std::string message = path.string() + ": " + what + ": " + std::strerror(errno);
    ::unlink(temporary.c_str());
    return message;
  };
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return failure("cannot be created");
  const bool written = write_all(descriptor, text) && ::fsync(descriptor) == 0;
  const int write_error = errno;
  ::close(descriptor);
  if (!written) {
    errno = write_error;
    return failure("cannot be written");
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) return failure("cannot be put in place");
  return std::nullopt;
}

}  // namespace wheelwright::config

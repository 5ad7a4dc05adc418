#include "config/load/text_file.hpp"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <optional>
#include <utility>

#include "config/load/text_format.hpp"

namespace wheelwright::config {
namespace {

using Failure = tl::unexpected<std::string>;

constexpr std::uint64_t mebibyte = 1U << 20U;
constexpr std::size_t pipe_block_bytes = 64U << 10U;

std::string why_not_opened(int error) {
  if (error == ENOENT || error == ENOTDIR) return "cannot be read; does the file exist?";
  if (error == EACCES || error == EPERM) return "cannot be read; do you have the permission?";
  return std::string("cannot be read: ") + std::strerror(error);
}

std::string too_large(const FileKind& kind, const std::string& size) {
  return "is " + size + " than the " + std::to_string(kind.max_bytes / mebibyte) + " MiB that " +
         std::string(kind.name) + " may have; split it, or name another file";
}

std::string in_mebibytes(std::uint64_t bytes) {
  return fixed_number(static_cast<double>(bytes) / static_cast<double>(mebibyte), 1) + " MiB";
}

// A pipe between two programs lies in a file system of its own; one that somebody named lies in a folder.
bool is_between_programs(const std::filesystem::path& pipe) {
  struct statfs system {};
  return ::statfs(pipe.c_str(), &system) == 0 && system.f_type == PIPEFS_MAGIC;
}

// What must not be opened, and why; nothing where the file is of a readable type and size.
std::optional<std::string> refusal(const std::filesystem::path& path, const struct stat& status,
                                   const FileKind& kind) {
  const mode_t type = status.st_mode & static_cast<mode_t>(S_IFMT);
  if (type == S_IFREG) {
    const auto size = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
    return size > kind.max_bytes ? std::optional(too_large(kind, "of " + in_mebibytes(size) + ", more"))
                                 : std::nullopt;
  }
  if (type == S_IFDIR) return "is a folder, but must be a file";
  if (type == S_IFSOCK) return "is a socket, but must be a file";
  if (type != S_IFIFO) return "is a device, but must be a file";
  if (is_between_programs(path)) return std::nullopt;
  return "is a named pipe, but must be a file, or a pipe of the shell such as <(zcat log.csv.gz)";
}

class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

// One byte more than the file said it has shows its end; what says 0, as in /proc, is read until it ends.
tl::expected<std::string, std::string> read_to_end(int descriptor, const struct stat& status,
                                                   const FileKind& kind) {
  const bool is_file = S_ISREG(status.st_mode);
  const auto announced = is_file ? static_cast<std::size_t>(status.st_size) : 0;
  std::string text;
  std::size_t filled = 0;
  text.resize(announced + 1);
  while (true) {
    if (filled == text.size())
      text.resize(std::min<std::uint64_t>(std::max(2 * filled, pipe_block_bytes), kind.max_bytes + 1));
    const ssize_t count = ::read(descriptor, text.data() + filled, text.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      return Failure("cannot be read to its end: " + std::string(std::strerror(errno)) + " after " +
                     std::to_string(filled) + " bytes");
    }
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
    if (filled > kind.max_bytes) return Failure(too_large(kind, "longer"));
  }
  if (filled < announced) {
    return Failure("became shorter while it was read, from " + std::to_string(announced) + " to " +
                   std::to_string(filled) + " bytes; try again");
  }
  if (!is_file && filled == 0) {
    return Failure("is a pipe that holds nothing; where a command reads its input twice, give it a file");
  }
  text.resize(filled);
  return text;
}

tl::expected<std::string, std::string> read_checked(const std::filesystem::path& path, const FileKind& kind) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return Failure(why_not_opened(errno));
  if (auto why = refusal(path, status, kind)) return Failure(*std::move(why));
  const OpenFile file(path);
  if (file.descriptor() < 0 || ::fstat(file.descriptor(), &status) != 0)
    return Failure(why_not_opened(errno));
  // The name may stand for something else by now.
  if (auto why = refusal(path, status, kind)) return Failure(*std::move(why));
  if (S_ISFIFO(status.st_mode) && ::fcntl(file.descriptor(), F_SETFL, 0) != 0)  // waits for the other program
    return Failure(why_not_opened(errno));
  return read_to_end(file.descriptor(), status, kind);
}

}  // namespace

tl::expected<std::string, std::string> read_text(const std::filesystem::path& path, const FileKind& kind) {
  tl::expected<std::string, std::string> text;
  try {
    text = read_checked(path, kind);
  } catch (const std::bad_alloc&) {
    text = Failure("is too large for the free memory of this machine");
  }
  if (!text) text = Failure(path.string() + ": " + text.error());
  return text;
}

}  // namespace wheelwright::config

#include "config/load/output_file.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

namespace wheelwright::config {
namespace {

namespace fs = std::filesystem;
using Problem = std::optional<std::string>;

constexpr std::size_t head_bytes = 1UL << 18U;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int get() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

std::string because(const fs::path& path, const std::string& what) {
  return path.string() + ": " + what + ": " + std::strerror(errno);
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool same_file(const struct stat& one, const struct stat& other) {
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

Problem refuse_type(const fs::path& path, mode_t mode) {
  const char* what = S_ISLNK(mode)    ? "is a symbolic link"
                     : S_ISDIR(mode)  ? "is a folder"
                     : S_ISCHR(mode)  ? "is a device"
                     : S_ISBLK(mode)  ? "is a device"
                     : S_ISFIFO(mode) ? "is a pipe"
                     : S_ISSOCK(mode) ? "is a socket"
                                      : nullptr;
  if (what == nullptr) return std::nullopt;
  return path.string() + ": " + what + ", which an output does not replace; name a file";
}

Problem refuse_input(const fs::path& path, const struct stat& there, const InputFiles& inputs) {
  for (const fs::path& input : inputs) {
    struct stat read {};
    if (input.empty() || ::stat(input.c_str(), &read) != 0 || !same_file(there, read)) continue;
    return path.string() + ": would replace an input" + (input == path ? "" : ", " + input.string()) +
           "; give the output another name";
  }
  return std::nullopt;
}

Problem refuse_kind(const OutputFile& output, int descriptor) {
  if (output.kind == OutputKind::any) return std::nullopt;
  std::string head(head_bytes, '\0');
  std::size_t size = 0;
  while (size < head.size()) {
    const ssize_t n = ::pread(descriptor, head.data() + size, head.size() - size, static_cast<off_t>(size));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return because(output.path, "cannot be read, to see whether it may be replaced");
    if (n == 0) break;
    size += static_cast<std::size_t>(n);
  }
  head.resize(size);
  if (head.empty() || is_of_kind(output.kind, head)) return std::nullopt;
  return output.path.string() +
         ": holds something else than this output, and is not replaced; remove it or give another name";
}

// Whether what is at the path may be replaced, through a descriptor that is sure to be of that very file.
Problem refuse_file(const OutputFile& output, int descriptor, const InputFiles& inputs) {
  struct stat there {};
  if (::fstat(descriptor, &there) != 0) return because(output.path, "cannot be examined");
  if (auto problem = refuse_type(output.path, there.st_mode)) return problem;
  if (auto problem = refuse_input(output.path, there, inputs)) return problem;
  return refuse_kind(output, descriptor);
}

// The file that is at the path now; nothing where there is none.
struct Existing {
  Problem problem;
  std::optional<struct stat> file;
};

Existing examine(const OutputFile& output, const InputFiles& inputs) {
  struct stat there {};
  if (::lstat(output.path.c_str(), &there) != 0) {
    if (errno == ENOENT) return {};
    return {because(output.path, "cannot be written"), {}};
  }
  if (auto problem = refuse_type(output.path, there.st_mode)) return {problem, {}};
  if (auto problem = refuse_input(output.path, there, inputs)) return {problem, {}};
  if (::faccessat(AT_FDCWD, output.path.c_str(), W_OK, AT_EACCESS) != 0) {
    return {because(output.path, "cannot be written"), {}};
  }
  const Descriptor file(
      ::open(output.path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.get() < 0) {
    if (output.kind == OutputKind::any && errno == EACCES) return {std::nullopt, there};
    return {because(output.path, "cannot be read, to see whether it may be replaced"), {}};
  }
  return {refuse_file(output, file.get(), inputs), there};
}

Problem check_folder(const fs::path& path) {
  const fs::path folder = folder_of(path);
  struct stat there {};
  if (::stat(folder.c_str(), &there) != 0) return because(path, "cannot be written: its folder");
  if (!S_ISDIR(there.st_mode))
    return path.string() + ": cannot be written: " + folder.string() + " is no folder";
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    return because(path, "cannot be written: its folder");
  }
  return std::nullopt;
}

Problem check_place(const fs::path& path) {
  if (!path.has_filename()) return path.string() + ": is no name of a file; name a file";
  return check_folder(path);
}

Problem check_output(const OutputFile& output, const InputFiles& inputs) {
  if (auto problem = check_place(output.path)) return problem;
  return examine(output, inputs).problem;
}

// One name however it is spelled: the folder resolved, and the last part as it is.
fs::path resolved(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(folder_of(path), ignored), ignored) / path.filename();
}

bool are_one_file(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  return resolved(one) == resolved(other) || fs::equivalent(one, other, ignored);
}

std::string unique_name() {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number)) {
    number = static_cast<std::uint64_t>(::getpid());
  }
  std::array<char, 40> name{};
  std::snprintf(name.data(), name.size(), ".wheelwright-%016llx.part",
                static_cast<unsigned long long>(number));
  return name.data();
}

void keep_owner_and_mode(int descriptor, const struct stat& before) {
  struct stat made {};
  if (::fstat(descriptor, &made) == 0 && (made.st_uid != before.st_uid || made.st_gid != before.st_gid)) {
    // Only root may give a file away; where we may not, it stays ours.
    [[maybe_unused]] const int ignored = ::fchown(descriptor, before.st_uid, before.st_gid);
  }
  ::fchmod(descriptor, before.st_mode & 0777U);
}

bool is_unchanged(const char* path, const std::optional<struct stat>& before) {
  struct stat now {};
  if (::lstat(path, &now) != 0) return !before;
  return before && same_file(*before, now);
}

// A file that was not there before does not replace one that came meanwhile.
bool put_in_place(int folder, const std::string& temporary, const fs::path& path, bool is_new) {
  const std::string name = path.filename().string();
  if (is_new) {
    if (::renameat2(folder, temporary.c_str(), folder, name.c_str(), RENAME_NOREPLACE) == 0) return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
  }
  return ::renameat(folder, temporary.c_str(), folder, name.c_str()) == 0;
}

}  // namespace

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

std::optional<std::string> check_outputs(std::span<const OutputFile> outputs, const InputFiles& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (auto problem = check_output(outputs[i], inputs)) return problem;
    for (std::size_t k = 0; k < i; ++k) {
      if (!are_one_file(outputs[k].path, outputs[i].path)) continue;
      return outputs[i].path.string() + ": is named for two outputs; give each a name of its own";
    }
  }
  return std::nullopt;
}

std::optional<std::string> check_output_folder(const fs::path& folder, const OutputFile& marker,
                                               std::span<const std::string_view> names,
                                               const InputFiles& inputs) {
  struct stat there {};
  if (::stat(folder.c_str(), &there) != 0) return std::nullopt;
  if (!S_ISDIR(there.st_mode))
    return folder.string() + ": is a file, but must be a folder; give another name";
  const OutputFile mark{folder / marker.path, marker.kind};
  const Existing former = examine(mark, inputs);
  if (former.problem) return former.problem;
  for (const std::string_view name : names) {
    const OutputFile output{folder / name, OutputKind::any};
    const Existing existing = examine(output, inputs);
    if (existing.problem) return existing.problem;
    if (!existing.file || former.file) continue;
    return output.path.string() +
           ": is there already, in a folder that this command did not fill (it has no " +
           marker.path.string() + "); give a folder of its own";
  }
  return check_folder(mark.path);
}

std::optional<std::string> write_output(const OutputFile& output, std::string_view text) {
  if (auto problem = check_place(output.path)) return problem;
  const Existing before = examine(output, {});
  if (before.problem) return before.problem;
  const Descriptor folder(::open(folder_of(output.path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) return because(output.path, "cannot be written: its folder");
  const std::string temporary = unique_name();
  const Descriptor file(
      ::openat(folder.get(), temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
  if (file.get() < 0) return because(output.path, "cannot be created");
  const auto failure = [&](const char* what) {
    std::string message = because(output.path, what);
    ::unlinkat(folder.get(), temporary.c_str(), 0);
    return message;
  };
  if (before.file) keep_owner_and_mode(file.get(), *before.file);
  if (!write_all(file.get(), text) || ::fsync(file.get()) != 0) return failure("cannot be written");
  if (!is_unchanged(output.path.c_str(), before.file)) {
    ::unlinkat(folder.get(), temporary.c_str(), 0);
    return output.path.string() + ": was replaced by another program meanwhile, and is left as it is";
  }
  if (!put_in_place(folder.get(), temporary, output.path, !before.file))
    return failure("cannot be put in place");
  ::fsync(folder.get());
  return std::nullopt;
}

tl::expected<int, std::string> open_output(const OutputFile& output, const InputFiles& inputs) {
  if (auto problem = check_output(output, inputs)) return tl::unexpected(*std::move(problem));
  constexpr int always = O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const int made = ::open(output.path.c_str(), O_RDWR | O_CREAT | O_EXCL | always, 0644);
  if (made >= 0) return made;
  if (errno != EEXIST) return tl::unexpected(because(output.path, "cannot be created"));
  Descriptor file(::open(output.path.c_str(), O_RDWR | always));
  if (file.get() < 0) return tl::unexpected(because(output.path, "cannot be written"));
  if (auto problem = refuse_file(output, file.get(), inputs)) return tl::unexpected(*std::move(problem));
  struct stat there {};
  if (::fstat(file.get(), &there) != 0 || there.st_nlink > 1) {
    return tl::unexpected(output.path.string() +
                          ": has a second name (a hard link), whose file it would empty; give another name");
  }
  if (::ftruncate(file.get(), 0) != 0) return tl::unexpected(because(output.path, "cannot be written"));
  return file.release();
}

}  // namespace wheelwright::config

#include "drivers/simulation/terminal_holder.hpp"

#include <sys/stat.h>

#include <charconv>
#include <fstream>

namespace wheelwright::simulation {
namespace {

namespace fs = std::filesystem;

// Linux tells of an open /dev/ptmx which terminal it is the other end of.
bool is_end_of(const fs::path& descriptor_info, const std::string& terminal_number) {
  std::ifstream info(descriptor_info);
  std::string key;
  std::string value;
  while (info >> key >> value) {
    if (key == "tty-index:") return value == terminal_number;
  }
  return false;
}

// A container has terminals of its own, which are counted from 0 as well.
bool is_of_this_system(const fs::path& descriptor) {
  struct stat held {};
  struct stat own {};
  if (::stat(descriptor.c_str(), &held) != 0) return false;
  for (const char* const maker : {"/dev/ptmx", "/dev/pts/ptmx"}) {
    if (::stat(maker, &own) == 0 && own.st_dev == held.st_dev) return true;
  }
  return false;
}

bool holds(const fs::path& process, const std::string& terminal_number) {
  std::error_code error;
  for (fs::directory_iterator at(process / "fd", error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const fs::path target = fs::read_symlink(at->path(), gone);
    if (target.filename() == "ptmx" && is_of_this_system(at->path()) &&
        is_end_of(process / "fdinfo" / at->path().filename(), terminal_number))
      return true;
  }
  return false;
}

}  // namespace

std::optional<TerminalHolder> holder_of(const fs::path& terminal) {
  const std::string number = terminal.filename().string();
  std::error_code error;
  for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
    const std::string word = at->path().filename().string();
    TerminalHolder holder;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), holder.pid);
    if (parsed.ec != std::errc{} || parsed.ptr != word.data() + word.size()) continue;
    if (!holds(at->path(), number)) continue;
    std::ifstream name(at->path() / "comm");
    std::getline(name, holder.name);
    return holder;
  }
  return std::nullopt;
}

}  // namespace wheelwright::simulation

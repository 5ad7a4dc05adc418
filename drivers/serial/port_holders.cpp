#include "drivers/serial/port_holders.hpp"

#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace wheelwright::serial {
namespace {

namespace fs = std::filesystem;

std::string program_of(const fs::path& process) {
  std::ifstream file(process / "comm");
  std::string name;
  std::getline(file, name);
  // Whoever runs a program chooses its name.
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isprint(static_cast<unsigned char>(c)) == 0; }, '?');
  return name;
}

enum class Hold { none, port, far_end };

Hold hold_of(const fs::path& process, const struct stat& port, bool is_pseudo_terminal) {
  Hold hold = Hold::none;
  std::error_code error;
  for (fs::directory_iterator at(process / "fd", error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const fs::path target = fs::read_symlink(at->path(), gone);
    if (!target.string().starts_with("/dev/")) continue;
    if (is_pseudo_terminal && target.filename() == "ptmx") return Hold::far_end;
    struct stat held {};
    if (::stat(at->path().c_str(), &held) != 0) continue;
    if (S_ISCHR(held.st_mode) && held.st_rdev == port.st_rdev && held.st_dev == port.st_dev)
      hold = Hold::port;
  }
  return hold;
}

}  // namespace

std::vector<PortHolder> other_holders(const fs::path& port) {
  std::vector<PortHolder> holders;
  struct stat status {};
  if (::stat(port.c_str(), &status) != 0 || !S_ISCHR(status.st_mode)) return holders;
  std::error_code ignored;
  const bool is_pseudo_terminal = fs::canonical(port, ignored).string().starts_with("/dev/pts/");
  std::error_code error;
  for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
    const std::string word = at->path().filename().string();
    PortHolder holder;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), holder.pid);
    if (parsed.ec != std::errc{} || parsed.ptr != word.data() + word.size()) continue;
    if (holder.pid == ::getpid()) continue;
    if (hold_of(at->path(), status, is_pseudo_terminal) != Hold::port) continue;
    holder.program = program_of(at->path());
    holders.push_back(std::move(holder));
  }
  return holders;
}

pid_t lock_owner(const fs::path& port) {
  struct stat status {};
  if (::stat(port.c_str(), &status) != 0) return 0;
  std::ifstream locks("/proc/locks");
  // 1: FLOCK  ADVISORY  WRITE 4711 00:05:83 0 EOF
  for (std::string line; std::getline(locks, line);) {
    unsigned major_number = 0;
    unsigned minor_number = 0;
    unsigned long inode = 0;
    int pid = 0;
    if (std::sscanf(line.c_str(), "%*d: FLOCK %*s %*s %d %x:%x:%lu", &pid, &major_number, &minor_number,
                    &inode) != 4)
      continue;
    const bool same_device = ::major(status.st_dev) == major_number && ::minor(status.st_dev) == minor_number;
    if (same_device && status.st_ino == inode && pid > 0 && pid != ::getpid()) return pid;
  }
  return 0;
}

std::string names_of(const std::vector<PortHolder>& holders) {
  std::string names;
  for (const PortHolder& holder : holders) {
    names += (names.empty() ? "" : " and ") + (holder.program.empty() ? "a program" : holder.program) +
             " (process " + std::to_string(holder.pid) + ")";
  }
  return names;
}

std::string in_use_by(const fs::path& port) {
  const auto holders = other_holders(port);
  if (!holders.empty()) return "in use by " + names_of(holders) + "; end it first";
  const pid_t owner = lock_owner(port);
  if (owner != 0)
    return "in use by " + names_of({{owner, program_of("/proc/" + std::to_string(owner))}}) +
           "; end it first";
  return "in use by another program, which cannot be seen from this account; 'sudo fuser -v " +
         port.string() + "' names it; end it first";
}

}  // namespace wheelwright::serial

#include "drivers/simulation/pseudo_terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "drivers/simulation/terminal_holder.hpp"

namespace wheelwright::simulation {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

constexpr std::array<std::pair<speed_t, int>, 8> speeds{{{B300, 300},
                                                         {B1200, 1200},
                                                         {B4800, 4800},
                                                         {B9600, 9600},
                                                         {B19200, 19200},
                                                         {B38400, 38400},
                                                         {B57600, 57600},
                                                         {B115200, 115200}}};

// A link that leads to something would be taken from whoever relies on it. A terminal is gone with the
// process that held it, so a link that a killed process left behind leads nowhere.
void refuse_link_in_use(const std::filesystem::path& link) {
  std::error_code error;
  const auto target = std::filesystem::canonical(link, error);
  if (error) return;
  const auto holder = holder_of(target);
  if (holder && holder->pid == getpid()) return;
  const std::string who =
      holder ? ", which process " + std::to_string(holder->pid) + " (" + holder->name + ") holds"
             : ", which is there";
  throw std::runtime_error(link.string() + ": leads to " + target.string() + who +
                           "; end that, remove the link, or choose another --link");
}

// A robot that was killed leaves a link to a terminal behind; any other link is somebody else's.
void refuse_link_to_no_terminal(const std::filesystem::path& link) {
  std::error_code error;
  const std::string target = std::filesystem::read_symlink(link, error).string();
  if (target.starts_with("/dev/pts/")) return;
  throw std::runtime_error(link.string() + ": is a link to " + target +
                           ", not to a terminal of a simulated robot; choose another --link");
}

}  // namespace

PseudoTerminal::PseudoTerminal() : descriptor_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
  if (descriptor_ < 0) fail("cannot open a pseudo-terminal");
  std::array<char, 128> name{};
  if (grantpt(descriptor_) != 0 || unlockpt(descriptor_) != 0 ||
      ptsname_r(descriptor_, name.data(), name.size()) != 0) {
    close(descriptor_);
    fail("cannot set up a pseudo-terminal");
  }
  path_ = name.data();
  termios settings{};
  tcgetattr(descriptor_, &settings);
  cfmakeraw(&settings);
  cfsetspeed(&settings, B115200);
  tcsetattr(descriptor_, TCSANOW, &settings);
  // Only after its first client has gone does the system tell whether there is a client.
  const int client = open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (client >= 0) close(client);
}

PseudoTerminal::~PseudoTerminal() {
  close(descriptor_);
}

bool PseudoTerminal::client_is_there() {
  pollfd state{descriptor_, POLLIN, 0};
  poll(&state, 1, 0);
  const bool there = (state.revents & POLLHUP) == 0;
  if (had_client_ && !there) {
    // The next client must not find what the last one left unread.
    const int client = open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (client >= 0) {
      tcflush(client, TCIFLUSH);
      close(client);
    }
  }
  had_client_ = there;
  return there;
}

std::size_t PseudoTerminal::read(std::span<std::uint8_t> bytes) {
  const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void PseudoTerminal::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty() && client_is_there()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count <= 0) return;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

std::optional<int> PseudoTerminal::client_baud() {
  termios settings{};
  if (!client_is_there() || tcgetattr(descriptor_, &settings) != 0) return std::nullopt;
  for (const auto& [code, baud] : speeds) {
    if (cfgetospeed(&settings) == code) return baud;
  }
  return std::nullopt;
}

TerminalLink::TerminalLink(std::filesystem::path link, const std::string& target)
    : link_(std::move(link)), target_(target) {
  std::error_code error;
  const auto kind = std::filesystem::symlink_status(link_, error).type();
  if (kind == std::filesystem::file_type::symlink) {
    refuse_link_in_use(link_);
    refuse_link_to_no_terminal(link_);
    std::filesystem::remove(link_, error);
  } else if (kind != std::filesystem::file_type::not_found) {
    throw std::runtime_error(link_.string() + ": is in the way and no symbolic link; choose another --link");
  }
  std::filesystem::create_symlink(target_, link_, error);
  if (error) throw std::runtime_error(link_.string() + ": cannot be created: " + error.message());
}

TerminalLink::~TerminalLink() {
  std::error_code error;
  // Another robot may have taken over the name since.
  if (std::filesystem::read_symlink(link_, error) == target_) std::filesystem::remove(link_, error);
}

}  // namespace wheelwright::simulation

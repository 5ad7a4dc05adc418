#include "daemon/service/service_notifier.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <string_view>

#include "config/load/printable_text.hpp"

namespace wheelwright::daemon {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// A socket in the file system, or with a leading @ in the abstract name space.
int connected_to(std::string_view name) {
  sockaddr_un address{};
  if (name.size() < 2 || name.size() >= sizeof(address.sun_path)) return -1;
  if (name.front() != '/' && name.front() != '@') return -1;
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path);
  if (name.front() == '@') address.sun_path[0] = '\0';
  const int descriptor = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  const auto* generic = static_cast<const sockaddr*>(static_cast<const void*>(&address));
  if (descriptor >= 0 && ::connect(descriptor, generic, size) != 0) {
    ::close(descriptor);
    return -1;
  }
  return descriptor;
}

std::optional<std::chrono::microseconds> watchdog_time() {
  const std::string_view text = variable("WATCHDOG_USEC");
  std::int64_t microseconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), microseconds);
  if (error != std::errc() || end != text.data() + text.size() || microseconds <= 0) return std::nullopt;
  return std::chrono::microseconds(microseconds);
}

}  // namespace

ServiceNotifier::ServiceNotifier()
    : socket_(connected_to(variable("NOTIFY_SOCKET"))), watchdog_(watchdog_time()) {}

ServiceNotifier::~ServiceNotifier() {
  if (socket_ >= 0) ::close(socket_);
}

void ServiceNotifier::send(const std::string& text) {
  if (socket_ >= 0) ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

void ServiceNotifier::ready() {
  if (!ready_) send("READY=1");
  ready_ = true;
}

void ServiceNotifier::status(const std::string& line) {
  if (line == last_status_) return;
  last_status_ = line;
  send("STATUS=" + config::printable(line));  // a line break would begin another assignment
}

void ServiceNotifier::feed(std::int64_t progress) {
  const auto now = std::chrono::steady_clock::now();
  if (!watchdog_ || progress == last_progress_ || now - last_feed_ < *watchdog_ / 4) return;
  last_progress_ = progress;
  last_feed_ = now;
  send("WATCHDOG=1");
}

void ServiceNotifier::stopping() {
  send("STOPPING=1");
}

}  // namespace wheelwright::daemon

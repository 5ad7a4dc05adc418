#include "tests/loopback/bench/notify_socket.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

namespace wheelwright::bench {

NotifySocket::NotifySocket() : name_("@wheelwright-test-" + std::to_string(::getpid())) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name_.begin() + 1, name_.end(), address.sun_path + 1);
  socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name_.size());
  const auto* generic = static_cast<const sockaddr*>(static_cast<const void*>(&address));
  if (socket_ < 0 || ::bind(socket_, generic, size) != 0) throw std::runtime_error("no socket to listen on");
}

NotifySocket::~NotifySocket() {
  ::close(socket_);
}

const std::vector<NotifySocket::Message>& NotifySocket::messages() {
  std::array<char, 1024> buffer{};
  for (ssize_t size = 0; (size = ::recv(socket_, buffer.data(), buffer.size(), 0)) > 0;) {
    messages_.push_back({Clock::now(), {buffer.data(), static_cast<std::size_t>(size)}});
  }
  return messages_;
}

bool NotifySocket::hears(const std::string& text, std::chrono::milliseconds at_most) {
  return eventually(at_most, [&] { return count_of(text) > 0; });
}

std::size_t NotifySocket::count_of(const std::string& text) {
  const auto& all = messages();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const Message& m) { return m.text.starts_with(text); }));
}

}  // namespace wheelwright::bench

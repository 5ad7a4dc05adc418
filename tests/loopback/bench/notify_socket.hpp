// The service manager's end of sd_notify(3): what the daemon says, with the time at which it said so.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "tests/loopback/bench/eventually.hpp"

namespace wheelwright::bench {

class NotifySocket {
 public:
  using Clock = std::chrono::steady_clock;
  struct Message {
    Clock::time_point at;
    std::string text;
  };

  // Listens on a name of its own in the abstract name space.
  NotifySocket();
  NotifySocket(const NotifySocket&) = delete;
  NotifySocket& operator=(const NotifySocket&) = delete;
  ~NotifySocket();

  // For NOTIFY_SOCKET in the daemon's environment.
  const std::string& name() const { return name_; }

  // What has come so far, from the first on.
  const std::vector<Message>& messages();
  // Waits for a message that begins with `text`.
  bool hears(const std::string& text, std::chrono::milliseconds at_most);
  std::size_t count_of(const std::string& text);

 private:
  int socket_ = -1;
  std::string name_;
  std::vector<Message> messages_;
};

}  // namespace wheelwright::bench

// An exception that ended a thread of the daemon, on its way to the supervisor, which ends the run in order.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace wheelwright::daemon {

class ThreadFailure {
 public:
  // The first one is kept: what follows is its consequence.
  void report(const std::string& what) {
    const std::lock_guard lock(mutex_);
    if (!what_) what_ = what;
  }
  std::optional<std::string> what() const {
    const std::lock_guard lock(mutex_);
    return what_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<std::string> what_;
};

}  // namespace wheelwright::daemon

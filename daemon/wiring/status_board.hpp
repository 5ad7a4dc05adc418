// The newest tick, for threads that only want to know how things are. Written by the log thread, which is no
// part of the hot path.
#pragma once

#include <mutex>
#include <optional>

#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon {

class StatusBoard {
 public:
  void put(const LogEntry& entry) {
    const std::lock_guard lock(mutex_);
    latest_ = entry;
  }
  std::optional<LogEntry> latest() const {
    const std::lock_guard lock(mutex_);
    return latest_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<LogEntry> latest_;
};

}  // namespace wheelwright::daemon

// What a service remembers from one process to the next, in its runtime folder: how often in a row it ended
// out of order, and whether the robot was armed then. A reboot forgets it, and so does an end in order.
//
// From it come the back-off (systemd 252 has none that grows) and the rule that a daemon which takes over
// from one that was killed does not drive off on its own.
#pragma once

#include <chrono>
#include <filesystem>

namespace wheelwright::daemon {

class Restarts {
 public:
  // An empty folder: nothing is remembered. Counts this process as one that ends out of order, until told
  // better.
  explicit Restarts(const std::filesystem::path& folder);

  // How long to wait before anything is tried: nothing at first, then 1 s, then twice as long each time, up
  // to a minute.
  std::chrono::seconds back_off() const;
  // The process before this one ended out of order with the robot armed.
  bool was_armed() const { return was_armed_; }

  void armed();
  // The process has run long enough to be no part of a row.
  void lasted();
  void ended_in_order();

 private:
  std::filesystem::path attempts_file_;
  std::filesystem::path armed_file_;
  int attempts_before_ = 0;
  bool was_armed_ = false;
  bool lasted_ = false;
};

}  // namespace wheelwright::daemon

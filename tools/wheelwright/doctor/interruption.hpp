// Ctrl-C as an exception, so that the robot is put to rest on the same way out as after any other error.
#pragma once

#include <signal.h>

#include <array>
#include <stdexcept>

namespace wheelwright::tools::doctor {

class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted; the robot is at rest") {}
};

// As long as it lives, SIGINT, SIGTERM and SIGHUP do not end the process; throw_if_interrupted() then throws.
class InterruptionWatch {
 public:
  InterruptionWatch();
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;
  ~InterruptionWatch();

 private:
  std::array<struct sigaction, 3> before_{};
};

void throw_if_interrupted();

}  // namespace wheelwright::tools::doctor

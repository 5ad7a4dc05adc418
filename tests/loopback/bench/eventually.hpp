// Waiting for something that another process does.
#pragma once

#include <chrono>
#include <thread>

namespace wheelwright::bench {

// Looks every few milliseconds until `condition` holds; false where it does not in time.
template <typename Condition>
bool eventually(std::chrono::milliseconds at_most, Condition condition) {
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace wheelwright::bench

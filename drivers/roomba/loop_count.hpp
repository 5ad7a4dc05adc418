// A count that one thread advances, without a lock, and any thread may read.
#pragma once

#include <atomic>
#include <cstdint>

namespace wheelwright::roomba {

class LoopCount {
 public:
  void add(std::int64_t n = 1) { set(value() + n); }
  void set(std::int64_t value) { value_.store(value, std::memory_order_relaxed); }
  std::int64_t value() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::int64_t> value_{0};
};

}  // namespace wheelwright::roomba

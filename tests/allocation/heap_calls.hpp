// Counts what a thread asks of the heap.
//
// The functions of the C library are replaced in this program (heap_calls.cpp): replacing operator new would
// miss Eigen, which asks malloc itself.
#pragma once

#include <atomic>
#include <cstdint>

namespace wheelwright::test {

// Requests and releases, which may take a lock just as well.
using HeapCalls = std::atomic<std::uint64_t>;

// From now on the calling thread counts in `calls`, which must outlive it; null ends the counting.
void count_heap_calls_in(HeapCalls* calls);

// Counts those of the calling thread within a scope.
class CountedScope {
 public:
  explicit CountedScope(HeapCalls& calls) { count_heap_calls_in(&calls); }
  ~CountedScope() { count_heap_calls_in(nullptr); }
  CountedScope(const CountedScope&) = delete;
  CountedScope& operator=(const CountedScope&) = delete;
};

}  // namespace wheelwright::test

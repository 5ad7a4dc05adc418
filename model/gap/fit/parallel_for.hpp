// How independent jobs of an analysis are run. The caller says how: nothing in model/ knows of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace wheelwright::gap {

// Calls a job for 0 .. count-1, in any order, perhaps side by side; returns when all are done.
using ParallelFor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

// One after the other.
inline void serial_for(std::size_t count, const std::function<void(std::size_t)>& job) {
  for (std::size_t i = 0; i < count; ++i) job(i);
}

}  // namespace wheelwright::gap

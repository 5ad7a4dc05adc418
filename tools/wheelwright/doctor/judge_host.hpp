// What the machine gives to a loop that has to be on time.
#pragma once

#include <vector>

#include "config/load/daemon_config.hpp"
#include "tools/wheelwright/doctor/finding.hpp"
#include "tools/wheelwright/doctor/period_fit.hpp"

namespace wheelwright::tools::doctor {

struct HostFigures {
  bool real_time_kernel = false;
  std::string release;          // of the kernel
  int priority = 0;             // SCHED_FIFO priority that was obtained; 0: none
  std::string lockable_memory;  // the limit, for people
  bool memory_can_be_locked = false;
  Spread lateness;  // of wake-ups at the loop's period
  int skipped_periods = 0;
};

// Asks for real-time scheduling as the daemon does, and sleeps through 2 s of periods. Throws Interrupted.
HostFigures examine_host(const config::RealTimeConfig& wanted, double period_s);

// kernel, SCHED_FIFO, locked memory, wake-up lateness. Pure.
std::vector<Finding> judge_host(const HostFigures& host, const config::RealTimeConfig& wanted,
                                double period_s);

}  // namespace wheelwright::tools::doctor

// What the sensor loop needs of the system to be on time: memory that is never paged, and a real-time
// scheduler.
#pragma once

#include <string>

#include "config/load/daemon_config.hpp"

namespace wheelwright::daemon {

// What was asked for and what the system gave.
struct RealTimeStatus {
  bool memory_locked = false;
  bool real_time_kernel = false;
  int priority = 0;       // SCHED_FIFO priority that the loop runs at; 0 for the ordinary scheduler
  std::string shortfall;  // why something was not to be had, with the remedy; empty where nothing is missing
};

// Whether the kernel is a PREEMPT_RT one.
bool is_real_time_kernel();

// For the whole process, before any thread starts: small stacks, and no heap given back to the system.
void set_up_allocation();

// For the whole process: memory locked, where it is asked for.
RealTimeStatus set_up_process(const config::RealTimeConfig& config);

// For the calling thread, which is the sensor loop. Adds to `status` what it got.
void set_up_loop_thread(const config::RealTimeConfig& config, RealTimeStatus& status);

// For the calling thread, which makes the loop's commands: below the loop, above everything else. Where the
// loop got no real-time scheduling this asks for none.
void set_up_predictor_thread(const RealTimeStatus& status);

// One line: kernel, scheduler, memory.
std::string describe(const RealTimeStatus& status);

// Names the calling thread for top, perf and debuggers; at most 15 characters.
void name_thread(const char* name);

}  // namespace wheelwright::daemon

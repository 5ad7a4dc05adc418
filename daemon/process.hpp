// The daemon as a process: wiring, threads, signals, and the exit status.
#pragma once

#include <filesystem>

#include "config/load/daemon_config.hpp"

namespace wheelwright::daemon {

// Runs until the mission ends, a signal asks for the end, or something forbids going on. Returns the exit
// status: 0 done, 1 ran and did not reach its end, 2 could not start.
//
// SIGTERM, SIGINT  wheels to rest, logs closed, out
// SIGUSR1          arm: clears a latched stop and starts the mission (again)
// SIGUSR2          stop: wheels to rest, the process stays
//
// Where `lateness_file` is not empty, the histogram of the loop's wake-ups is written there at the end.
int run_process(const config::DaemonConfig& config, const std::filesystem::path& lateness_file = {});

}  // namespace wheelwright::daemon

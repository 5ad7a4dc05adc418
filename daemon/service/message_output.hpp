// Where the daemon's messages go: standard error or the journal, through a queue that no thread waits for.
#pragma once

#include <chrono>
#include <string_view>

#include "config/load/daemon_config.hpp"

namespace wheelwright::daemon {

// Installs spdlog's default logger. As a service messages go to the journal, where there is one. Call it
// before any other thread starts. Throws StartFailure where the system has no thread left.
void set_up_messages(const config::DaemonConfig& config, bool as_service);

// Before the process ends: waits until the messages are written, 1 s at most. False where nobody takes them;
// then only _exit ends the process for sure, since a thread still holds standard error.
bool drain_messages();

// Writes to standard output or standard error, for at most `patience`: nobody may be reading. False where not
// all was taken in that time; then a thread is left behind that still tries.
bool print_within(std::chrono::milliseconds patience, int descriptor, std::string_view text);

}  // namespace wheelwright::daemon

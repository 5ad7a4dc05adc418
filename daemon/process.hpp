// The daemon as a process: wiring, threads, signals, and how it ends.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "config/load/daemon_config.hpp"
#include "daemon/service/exit_status.hpp"
#include "daemon/service/restarts.hpp"
#include "daemon/service/service_notifier.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::daemon {

// The command line.
struct ProcessOptions {
  std::filesystem::path config_file;
  std::filesystem::path device;         // instead of the configuration's; empty: that one
  std::filesystem::path commands_file;  // drive log whose commands are driven, and nothing else; empty: none
  std::filesystem::path lateness_file;  // histogram of the loop's wake-ups, written at the end; empty: none
  std::filesystem::path
      status_file;  // written again every second (daemon/telemetry/status_file.hpp); empty: none
  bool as_service = false;
};

// What lasts from run to run of one process.
struct Service {
  ServiceNotifier notifier;
  Restarts restarts;
  std::optional<std::string> hold;  // why the robot is not armed by itself, though the configuration says so
  bool from_terminal = false;       // whose hang-up (SIGHUP) is the end of the operator
  bool arms_next_run = false;       // the signal that arms began it
};

// Reads the configuration that the options name. Throws config::ConfigError.
config::DaemonConfig load_configuration(const ProcessOptions& options);

// The model that a run would start with. Throws config::ConfigError where it cannot be read.
std::optional<RobotModel> known_model(const config::DaemonConfig& config);

// Runs until the mission ends, a signal asks for the end, or something forbids going on. Throws StartFailure
// or another exception where it could not start.
//
// SIGTERM, SIGINT  wheels to rest, logs closed, out
// SIGUSR1          arm: clears a latched stop and starts the mission, after a run as another with a folder of
//                  its own; nothing while the robot drives
// SIGUSR2          stop: wheels to rest, the process stays
// SIGHUP           reload the configuration, all of it, unless the robot drives or there is a mistake in it;
//                  the robot is not armed by it. A daemon that was started from a terminal ends as by
//                  SIGTERM, since the terminal was closed
// SIGXCPU          a limit of processor time is reached: as SIGTERM
EndCause run_process(const ProcessOptions& options);

}  // namespace wheelwright::daemon

#include "daemon/process.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <spdlog/spdlog.h>
#include <sys/signal.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>

#include "config/load/atomic_file.hpp"
#include "config/load/commands_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/rest_target.hpp"
#include "daemon/guardian/rest.hpp"
#include "daemon/output_checks.hpp"
#include "daemon/run.hpp"
#include "daemon/telemetry/status_file.hpp"

namespace wheelwright::daemon {
namespace {

// Every thread inherits the mask: signals are only taken by the supervisor's sigtimedwait, which awaits
// SIGCHLD besides.
sigset_t block_signals() {
  sigset_t signals{};
  ::sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1, SIGUSR2, SIGHUP, SIGXCPU}) ::sigaddset(&signals, signal);
  sigset_t blocked = signals;
  ::sigaddset(&blocked, SIGCHLD);
  ::pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
  // What they tell of comes as an error of the write that they belong to.
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
  return signals;
}

// Puts the wheels of a robot to rest that the process before could not reach any more. False where there is
// no way to it yet.
bool has_rested(const ProcessOptions& options, const std::filesystem::path& runtime_folder) {
  try {
    return rest_wheels(rest_targets(runtime_folder, options.config_file, options.device));
  } catch (const StartFailure&) {
    return false;  // the run that comes says why
  }
}

// Waits out the back-off of a service that keeps failing. False where a signal asks for the end meanwhile.
bool wait_out(Service& service, const ProcessOptions& options, const std::optional<ServiceFolders>& folders,
              const sigset_t& signals) {
  const auto back_off = service.restarts.back_off();
  if (back_off.count() == 0) return true;
  bool must_rest = folders && lacks_farewell(folders->runtime);
  const std::string why =
      fmt::format("waiting {} s: the process ended out of order several times in a row", back_off.count());
  spdlog::warn("{}", why);
  service.notifier.status(why);
  const auto until = std::chrono::steady_clock::now() + back_off;
  while (std::chrono::steady_clock::now() < until) {
    if (must_rest) must_rest = !has_rested(options, folders->runtime);
    const timespec second{1, 0};
    const int signal = ::sigtimedwait(&signals, nullptr, &second);
    if (signal == SIGTERM || signal == SIGINT) return false;
  }
  return true;
}

// A variable of the service manager that names a folder, or several with colons in between.
std::filesystem::path folder_in(const char* variable) {
  const char* value = std::getenv(variable);
  const std::string names = value == nullptr ? "" : value;
  return names.substr(0, names.find(':'));
}

std::optional<ServiceFolders> service_folders(const ProcessOptions& options) {
  if (!options.as_service) return std::nullopt;
  return ServiceFolders{folder_in("RUNTIME_DIRECTORY"), folder_in("STATE_DIRECTORY")};
}

// Under nohup the process is to outlive its terminal.
bool started_from_terminal(const ProcessOptions& options) {
  struct sigaction hang_up {};
  ::sigaction(SIGHUP, nullptr, &hang_up);
  const int terminal = ::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal >= 0) ::close(terminal);
  return terminal >= 0 && !options.as_service && hang_up.sa_handler != SIG_IGN;
}

// For `wheelwrightd --rest`, which may find the configuration changed or gone.
void keep_rest_target(const config::DaemonConfig& config, const std::optional<ServiceFolders>& folders) {
  if (!folders || folders->runtime.empty()) return;
  const auto text = config::rest_target_to_yaml(config::rest_target(config));
  const auto error = config::write_file_atomically(folders->runtime / rest_target_file_name, text);
  if (error) spdlog::error("{}", *error);
}

// What the next process may do by itself depends on how this one ended.
void note_end(Restarts& restarts, const RunOutcome& outcome) {
  // Without its robot the run was not ended in order: nobody knows what the wheels do.
  if (outcome.cause == EndCause::robot_silent || outcome.cause == EndCause::internal) return;
  outcome.interrupted ? restarts.ended_in_drive() : restarts.ended_in_order();
}

}  // namespace

config::DaemonConfig load_configuration(const ProcessOptions& options) {
  auto config = config::load_daemon_config(options.config_file);
  if (!options.device.empty()) config.device = options.device;
  if (!options.commands_file.empty()) {
    config.commanded_drive =
        config::load_commands(options.commands_file, config.limits.largest_wheel_speed_m_s);
    config.route.reset();
    config.calibrate = config::CalibrateWhen::never;
  }
  return config;
}

std::optional<RobotModel> known_model(const config::DaemonConfig& config) {
  const bool wanted = config.calibrate != config::CalibrateWhen::always;
  if (!wanted || !std::filesystem::exists(config.model_file)) return std::nullopt;
  return config::load_model(config.model_file);
}

EndCause run_process(const ProcessOptions& options) {
  const sigset_t signals = block_signals();
  const auto folders = service_folders(options);
  Service service{{}, Restarts(folders), {}, started_from_terminal(options)};
  service.hold = service.restarts.hold();
  auto config = load_configuration(options);
  check_daemon_outputs(config, options);
  if (!wait_out(service, options, folders, signals)) return EndCause::asked;
  while (true) {
    keep_rest_target(config, folders);
    RunOutcome outcome = Run(config, options, service).drive(signals);
    if (!outcome.reload) {
      remove_own_status(options.status_file);
      if (folders && outcome.left_at_rest) note_farewell(folders->runtime);
      note_end(service.restarts, outcome);
      return outcome.cause;
    }
    config = std::move(*outcome.reload);
    service.arms_next_run = outcome.arms_next_run;
    if (outcome.arms_next_run) {
      service.hold.reset();
      continue;
    }
    spdlog::info("{}: loaded again", options.config_file.string());
    service.hold = "the configuration was loaded again";
  }
}

}  // namespace wheelwright::daemon

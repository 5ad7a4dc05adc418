#include "daemon/process.hpp"

#include <pthread.h>
#include <spdlog/spdlog.h>
#include <sys/signal.h>
#include <time.h>

#include <chrono>
#include <cstdlib>

#include "config/load/commands_file.hpp"
#include "config/load/model_file.hpp"
#include "daemon/run.hpp"

namespace wheelwright::daemon {
namespace {

// Every thread inherits the mask: signals are only taken by the supervisor's sigtimedwait.
sigset_t block_signals() {
  sigset_t signals{};
  ::sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1, SIGUSR2, SIGHUP}) ::sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
  return signals;
}

// Waits out the back-off of a service that keeps failing. False where a signal asks for the end meanwhile.
bool wait_out(Service& service, const sigset_t& signals) {
  const auto back_off = service.restarts.back_off();
  if (back_off.count() == 0) return true;
  const std::string why =
      fmt::format("waiting {} s: the process ended out of order several times in a row", back_off.count());
  spdlog::warn("{}", why);
  service.notifier.status(why);
  const auto until = std::chrono::steady_clock::now() + back_off;
  while (std::chrono::steady_clock::now() < until) {
    const timespec second{1, 0};
    const int signal = ::sigtimedwait(&signals, nullptr, &second);
    if (signal == SIGTERM || signal == SIGINT) return false;
  }
  return true;
}

std::filesystem::path runtime_folder(const ProcessOptions& options) {
  const char* folder = std::getenv("RUNTIME_DIRECTORY");
  return options.as_service && folder != nullptr ? folder : "";
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
  Service service{{}, Restarts(runtime_folder(options)), true, {}};
  if (service.restarts.was_armed()) {
    service.may_arm = false;
    service.why_not = "the process before this one was killed while the robot was armed";
  }
  auto config = load_configuration(options);
  if (!wait_out(service, signals)) return EndCause::asked;
  while (true) {
    RunOutcome outcome = Run(config, options, service).drive(signals);
    if (!outcome.reload) {
      std::error_code ignored;
      std::filesystem::remove(options.status_file, ignored);
      // Without its robot the run was not ended in order: nobody knows what the wheels do.
      if (outcome.cause != EndCause::robot_silent && outcome.cause != EndCause::internal) {
        service.restarts.ended_in_order();
      }
      return outcome.cause;
    }
    spdlog::info("{}: loaded anew", options.config_file.string());
    config = std::move(*outcome.reload);
    service.may_arm = false;
    service.why_not = "the configuration was loaded anew";
  }
}

}  // namespace wheelwright::daemon

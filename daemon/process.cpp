#include "daemon/process.hpp"

#include <pthread.h>
#include <spdlog/spdlog.h>
#include <sys/signal.h>
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>

#include "config/load/atomic_file.hpp"
#include "config/load/model_file.hpp"
#include "daemon/calibrator_thread.hpp"
#include "daemon/guardian.hpp"
#include "daemon/lateness_file.hpp"
#include "daemon/log_thread.hpp"
#include "daemon/open_device.hpp"
#include "daemon/plan.hpp"
#include "daemon/predictor_thread.hpp"
#include "daemon/real_time.hpp"
#include "daemon/ring_client.hpp"
#include "daemon/status_board.hpp"
#include "daemon/summary.hpp"
#include "daemon/supervisor.hpp"
#include "daemon/telemetry/live_view.hpp"

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

// What replay needs beside the drive log: the run's folder explains itself.
void keep_inputs(const std::filesystem::path& folder, const config::DaemonConfig& config, const Plan& plan) {
  const auto keep = [&](const char* name, const std::string& text) {
    if (const auto error = config::write_file_atomically(folder / name, text)) spdlog::error("{}", *error);
  };
  keep("config.yaml", config::daemon_config_to_yaml(config));
  if (plan.model) keep("model.yaml", config::model_to_yaml(*plan.model));
}

std::filesystem::path make_run_folder(const config::DaemonConfig& config) {
  std::string name = utc_now();
  for (char& c : name) {
    if (c == ':') c = '-';
  }
  std::filesystem::path folder = config.log_folder / name;
  std::error_code ignored;
  for (int next = 2; std::filesystem::exists(folder, ignored); ++next) {
    folder = config.log_folder / (name + "_" + std::to_string(next));
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw config::ConfigError(config.file.string() + ": log_folder: " + folder.string() +
                              " cannot be made (" + error.message() + "); name a folder that may be written");
  }
  return folder;
}

GuardianConfig guardian_config(const config::DaemonConfig& config) {
  const bool real_time = config.real_time.policy != config::RealTimePolicy::off;
  return {config.link.drive_mode, guardian_patience(config.link, false),
          real_time ? config.real_time.priority + 1 : 0, real_time && config.real_time.lock_memory};
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

// The same text for the folder of the run and, where one was asked for, for a file elsewhere.
void write_lateness(const std::filesystem::path& run_folder, const std::filesystem::path& elsewhere,
                    const std::string& text, LogReport& logs) {
  const auto write = [&](const std::filesystem::path& file) {
    if (const auto error = config::write_file_atomically(file, text)) {
      spdlog::error("{}", *error);
      logs.errors.push_back(*error);
    } else {
      logs.files.push_back(file);
    }
  };
  write(run_folder / lateness_file_name);
  if (!elsewhere.empty()) write(elsewhere);
}

RunOutcome run_once(const config::DaemonConfig& config, const ProcessOptions& options, Service& service,
                    const sigset_t& signals) {
  const Plan plan = make_plan(config, known_model(config));
  Guardian guardian(guardian_config(config));
  const serial::OpenPort port = open_device(config.device, config.baud);
  const auto folder = make_run_folder(config);
  keep_inputs(folder, config, plan);

  RealTimeStatus real_time = set_up_process(config.real_time);
  auto wiring = std::make_unique<Wiring>();
  RingClient client(*wiring);
  roomba::Session session({config.link, config.device, config.baud}, port, client, &guardian);
  Brain brain(plan.mission, plan.limits, plan.model ? std::make_unique<DrivingModel>(*plan.model) : nullptr);
  CalibratorThread calibrator(config, plan, folder, session, *wiring);
  StatusBoard board;
  LogThread log(config, folder, plan.limits.metres_per_tick, *wiring, board);

  telemetry::LiveView live_view(config, session, *wiring);

  // The real-time rights are settled before anything moves.
  std::atomic<int> scheduled{0};  // 0 not yet, 1 go, -1 refused
  std::thread loop([&] {
    name_thread("ww-loop");
    set_up_loop_thread(config.real_time, real_time);
    const bool refused =
        config.real_time.policy == config::RealTimePolicy::require && !real_time.shortfall.empty();
    scheduled.store(refused ? -1 : 1);
    scheduled.notify_one();
    if (!refused) session.run();
  });
  scheduled.wait(0);
  if (scheduled.load() < 0) {
    loop.join();
    throw StartFailure(EndCause::no_permission,
                       config.file.string() + ": real_time.policy is 'require', but " + real_time.shortfall);
  }
  guardian.set_patience(guardian_patience(config.link, real_time.priority > 0));
  spdlog::info("{}: {}{}", config.device.string(), describe(real_time),
               port.low_latency ? ", low-latency port" : "");
  if (!real_time.shortfall.empty()) spdlog::warn("{}", real_time.shortfall);
  if (port.latency_timer_ms && *port.latency_timer_ms > 2) {
    spdlog::warn("the adapter holds data for {} ms; systemd/ has the udev rule that sets 1 ms",
                 *port.latency_timer_ms);
  }

  std::thread predictor_thread([&] {
    name_thread("ww-predict");
    set_up_predictor_thread(real_time);
    run_predictor(brain, *wiring);
  });
  std::thread calibrator_thread([&] {
    name_thread("ww-calibrate");
    calibrator.run();
  });
  std::thread log_thread([&] {
    name_thread("ww-log");
    log.run();
  });
  std::thread live_view_thread([&] {
    name_thread("ww-live-view");
    live_view.run();
  });

  RunOutcome outcome =
      Supervisor({config, options, session, guardian, *wiring, board, real_time, folder}, service)
          .run(signals);

  if (!outcome.reload) service.notifier.stopping();
  session.request_end();
  loop.join();
  wiring->ending.store(true);
  wiring->frame_arrived.release();
  predictor_thread.join();
  calibrator_thread.join();
  log_thread.join();
  live_view.end(outcome.finished() ? "finished"
                : outcome.reload   ? "the configuration is loaded anew"
                                   : "stopped, " + outcome.stopped);
  live_view_thread.join();

  LogReport logs = log.report();
  write_lateness(folder, options.lateness_file,
                 lateness_text(lateness_record(session.lateness(), session.counts(), config.link.period_s,
                                               describe(real_time))),
                 logs);
  std::fputs(
      summary(config, outcome, calibrator.report(), logs, session, real_time, wiring->dropped.load()).c_str(),
      stdout);
  std::fflush(stdout);
  const bool complete = logs.errors.empty() && !calibrator.report().file_error;
  if (outcome.cause == EndCause::done && !complete) outcome.cause = EndCause::files_lost;
  return outcome;
}

}  // namespace

config::DaemonConfig load_configuration(const ProcessOptions& options) {
  auto config = config::load_daemon_config(options.config_file);
  if (!options.device.empty()) config.device = options.device;
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
    RunOutcome outcome = run_once(config, options, service, signals);
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

#include "daemon/process.hpp"

#include <pthread.h>
#include <spdlog/spdlog.h>
#include <sys/signal.h>
#include <time.h>

#include <cstdio>
#include <memory>
#include <thread>

#include "config/load/atomic_file.hpp"
#include "config/load/model_file.hpp"
#include "daemon/calibrator_thread.hpp"
#include "daemon/guardian.hpp"
#include "daemon/lateness_file.hpp"
#include "daemon/log_thread.hpp"
#include "daemon/plan.hpp"
#include "daemon/predictor_thread.hpp"
#include "daemon/real_time.hpp"
#include "daemon/ring_client.hpp"
#include "daemon/summary.hpp"

namespace wheelwright::daemon {
namespace {

constexpr int exit_done = 0;
constexpr int exit_no = 1;

constexpr double answer_patience_s = 15.0;
constexpr double linger_after_end_s = 0.5;  // the robot comes to rest, and the log gets to see it
constexpr long supervisor_period_ns = 50'000'000;
constexpr auto port_patience = std::chrono::milliseconds(1500);

// Every thread inherits the mask: signals are only taken by the supervisor's sigtimedwait.
sigset_t block_signals() {
  sigset_t signals{};
  ::sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1, SIGUSR2}) ::sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
  return signals;
}

std::optional<RobotModel> known_model(const config::DaemonConfig& config) {
  const bool wanted = config.calibrate != config::CalibrateWhen::always;
  if (!wanted || !std::filesystem::exists(config.model_file)) return std::nullopt;
  return config::load_model(config.model_file);
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
  for (int next = 2; std::filesystem::exists(folder); ++next) {
    folder = config.log_folder / (name + "_" + std::to_string(next));
  }
  std::filesystem::create_directories(folder);
  return folder;
}

GuardianConfig guardian_config(const config::DaemonConfig& config) {
  const bool real_time = config.real_time.policy != config::RealTimePolicy::off;
  return {config.link.drive_mode, guardian_patience(config.link.period_s),
          real_time ? config.real_time.priority + 1 : 0, real_time && config.real_time.lock_memory};
}

// The guardian of a daemon that was killed a moment ago still has the port, until the wheels stand.
serial::OpenPort open_port(const config::DaemonConfig& config) {
  const auto give_up = std::chrono::steady_clock::now() + port_patience;
  while (true) {
    const auto port = serial::open_port(config.device, config.baud);
    if (port) return *port;
    const bool in_use = port.error().kind == serial::PortErrorKind::in_use;
    if (!in_use || std::chrono::steady_clock::now() > give_up) {
      throw config::ConfigError(port.error().message);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

class Supervisor {
 public:
  Supervisor(const config::DaemonConfig& config, roomba::Session& session, Guardian& guardian, Wiring& wiring)
      : config_(config), session_(session), guardian_(guardian), wiring_(wiring) {}

  // Returns when the process is to end.
  RunOutcome run(const sigset_t& signals) {
    const timespec patience{0, supervisor_period_ns};
    while (true) {
      const int signal = ::sigtimedwait(&signals, nullptr, &patience);
      if (signal == SIGTERM || signal == SIGINT) {
        return wiring_.finished.load() ? RunOutcome{true, ""} : ended("ended by a signal");
      }
      if (signal == SIGUSR1) session_.request_arm();
      if (signal == SIGUSR2) session_.request_stop(StopReason::requested);
      elapsed_s_ += signal < 0 ? 1e-9 * static_cast<double>(supervisor_period_ns) : 0.0;
      arm_when_ready();
      if (config_.at_end == config::AtEnd::exit && run_is_over()) {
        return wiring_.finished.load() ? RunOutcome{true, ""}
                                       : ended(std::string(name_of(wiring_.stop.load())));
      }
      if (!guardian_.alive()) return ended("the guardian process has ended");
      if (gave_up_waiting()) {
        return ended("the robot does not answer on " + config_.device.string() +
                     "; try 'wheelwright doctor'");
      }
    }
  }

 private:
  static RunOutcome ended(const std::string& why) { return {false, why}; }

  void arm_when_ready() {
    if (armed_once_ || !config_.arm_at_start || !wiring_.robot_answers.load(std::memory_order_relaxed))
      return;
    armed_once_ = true;
    session_.request_arm();
  }

  bool run_is_over() {
    const bool over = wiring_.finished.load(std::memory_order_relaxed) ||
                      wiring_.stop.load(std::memory_order_relaxed) != StopReason::none;
    if (!over) over_since_s_ = elapsed_s_;
    return over && elapsed_s_ - over_since_s_ >= linger_after_end_s;
  }

  bool gave_up_waiting() const {
    return config_.at_end == config::AtEnd::exit && elapsed_s_ > answer_patience_s &&
           !wiring_.robot_answers.load(std::memory_order_relaxed);
  }

  const config::DaemonConfig& config_;
  roomba::Session& session_;
  Guardian& guardian_;
  Wiring& wiring_;
  bool armed_once_ = false;
  double elapsed_s_ = 0.0;
  double over_since_s_ = 0.0;
};

}  // namespace

int run_process(const config::DaemonConfig& config, const std::filesystem::path& lateness_file) {
  const sigset_t signals = block_signals();
  const Plan plan = make_plan(config, known_model(config));
  Guardian guardian(guardian_config(config));
  const serial::OpenPort port = open_port(config);
  const auto folder = make_run_folder(config);
  keep_inputs(folder, config, plan);

  RealTimeStatus real_time = set_up_process(config.real_time);
  auto wiring = std::make_unique<Wiring>();
  RingClient client(*wiring);
  roomba::Session session({config.link, config.device, config.baud}, port, client, &guardian);
  Brain brain(plan.mission, plan.limits, plan.model ? std::make_unique<DrivingModel>(*plan.model) : nullptr);
  CalibratorThread calibrator(config, plan, folder, session, *wiring);
  LogThread log(config, folder, plan.limits.metres_per_tick, *wiring);

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
    throw config::ConfigError(config.file.string() + ": real_time.policy is 'require', but " +
                              real_time.shortfall);
  }
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

  const RunOutcome outcome = Supervisor(config, session, guardian, *wiring).run(signals);

  session.request_end();
  loop.join();
  wiring->ending.store(true);
  wiring->frame_arrived.release();
  predictor_thread.join();
  calibrator_thread.join();
  log_thread.join();

  std::fputs(
      summary(config, outcome, calibrator.report(), log.report(), session, real_time, wiring->dropped.load())
          .c_str(),
      stdout);
  bool complete = log.report().errors.empty() && !calibrator.report().file_error;
  if (!lateness_file.empty()) {
    const auto error =
        config::write_file_atomically(lateness_file, lateness_text(session, config.link.period_s));
    if (error) spdlog::error("{}", *error);
    complete = complete && !error;
  }
  return outcome.finished && complete ? exit_done : exit_no;
}

}  // namespace wheelwright::daemon

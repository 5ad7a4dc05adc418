#include "daemon/run.hpp"

#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <system_error>
#include <utility>

#include "config/load/atomic_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/utc_now.hpp"
#include "daemon/recording/lateness_file.hpp"
#include "daemon/service/exit_status.hpp"
#include "daemon/service/message_output.hpp"
#include "daemon/silence_text.hpp"
#include "daemon/summary.hpp"
#include "daemon/threads/predictor_thread.hpp"

namespace wheelwright::daemon {
namespace {

std::filesystem::path make_run_folder(const config::DaemonConfig& config) {
  std::string name = config::utc_now();
  for (char& c : name) {
    if (c == ':') c = '-';
  }
  std::filesystem::path folder = config.log_folder / name;
  std::error_code ignored;
  std::filesystem::create_directories(config.log_folder, ignored);  // mkdir says what is wrong
  // One call that fails where the folder exists: of daemons that start together, each gets its own.
  for (int next = 2; ::mkdir(folder.c_str(), 0755) != 0; ++next) {
    if (errno != EEXIST) {
      throw config::ConfigError(config.file.string() + ": log_folder: " + folder.string() +
                                " cannot be made (" + std::strerror(errno) +
                                "); name a folder that may be written");
    }
    folder = config.log_folder / (name + "_" + std::to_string(next));
  }
  return folder;
}

GuardianConfig guardian_config(const config::DaemonConfig& config) {
  const bool real_time = config.real_time.policy != config::RealTimePolicy::off;
  return {config.link.drive_mode, guardian_patience(config.link, false),
          real_time ? config.real_time.priority + 1 : 0, real_time && config.real_time.lock_memory};
}

constexpr const char* finished = "finished";  // as /state calls it
constexpr auto summary_patience = std::chrono::seconds(2);
constexpr auto loop_patience =
    std::chrono::seconds(3);  // braking, and some commands that the port does not take

// A thread whose exception ends the run, not the process.
std::thread start_thread(const char* name, Wiring& wiring, std::function<void()> body) {
  return std::thread([name, &wiring, body = std::move(body)] {
    name_thread(name);
    try {
      body();
    } catch (const std::exception& error) {
      wiring.failure.report(std::string("the thread ") + name + " has ended: " + error.what());
    }
  });
}

bool are_all_short(const open_interface::ReplyCounts& replies) {
  return replies.sound == 0 && replies.incomplete > replies.asked / 2;
}

std::string ending_of(const RunOutcome& outcome) {
  if (outcome.finished()) return finished;
  return outcome.reload ? "the configuration is loaded again" : "stopped, " + outcome.stopped;
}

}  // namespace

Run::Run(const config::DaemonConfig& config, const ProcessOptions& options, Service& service)
    : config_(config),
      options_(options),
      service_(service),
      plan_(make_plan(config, known_model(config))),
      guardian_(guardian_config(config)),
      port_(open_device(config.device, config.baud)),
      folder_(make_run_folder(config)),
      real_time_(set_up_process(config.real_time)),
      wiring_(std::make_unique<Wiring>()),
      client_(*wiring_),
      sensor_loop_({config.link, config.device, config.baud}, port_, client_, &guardian_),
      brain_(plan_.mission, plan_.limits,
             plan_.model ? std::make_unique<DrivingModel>(*plan_.model) : nullptr),
      calibrator_(config, plan_, folder_, sensor_loop_, *wiring_),
      log_(config, folder_, plan_.limits.metres_per_tick, *wiring_, board_),
      live_view_(config, sensor_loop_, *wiring_),
      watch_(config, folder_) {
  keep_inputs();
}

// What replay needs beside the drive log: the run's folder explains itself.
void Run::keep_inputs() {
  const auto keep = [this](const char* name, const std::string& text) {
    if (const auto error = config::write_file_atomically(folder_ / name, text)) {
      spdlog::error("{}", *error);
      inputs_lost_.push_back(*error);
    }
  };
  keep("config.yaml", config::daemon_config_to_yaml(config_));
  if (plan_.model) keep("model.yaml", config::model_to_yaml(*plan_.model));
}

RunOutcome Run::drive(const sigset_t& signals) {
  start_all();
  RunOutcome outcome = supervise(signals);
  if (!outcome.reload) service_.notifier.stopping();
  end_loop();
  if (const auto& silence = sensor_loop_.silence(); silence && outcome.cause == EndCause::robot_silent) {
    outcome.stopped += "; " + explain(*silence, {config_.link.period_s, machine_load()});
  }
  if (const auto& replies = sensor_loop_.link().reply_counts();
      outcome.cause == EndCause::robot_silent && !wiring_->robot_answers.load() && are_all_short(replies)) {
    outcome.stopped += fmt::format(
        "; {} of {} replies came, but too short: the robot lacks sensors that are asked for (encoders, "
        "light bumper, motor currents), or its replies come later than a period",
        replies.incomplete, replies.asked);
  }
  const bool is_there = sensor_loop_.link().state() == roomba::LinkState::running;
  outcome.interrupted = outcome.interrupted || !is_there;
  end_threads(ending_of(outcome));
  if (!is_there && outcome.cause == EndCause::robot_silent && log_.report().logged_ticks > 0)
    outcome.stopped +=
        "; it could not be told to stand: lift it, plug it in, and run wheelwrightd with --rest";
  outcome.left_at_rest = is_there && outcome.cause != EndCause::internal;

  if (calibrator_.report().route_refusal && wiring_->stop.load() == StopReason::refused)
    outcome.stopped = "route refused";
  LogReport logs = log_.report();
  logs.errors.insert(logs.errors.end(), inputs_lost_.begin(), inputs_lost_.end());
  write_lateness(logs);
  print_within(summary_patience, STDOUT_FILENO,
               summary(config_, outcome, calibrator_.report(), logs, sensor_loop_, real_time_,
                       wiring_->dropped.load()));
  watch_after(outcome, logs, signals);
  const bool complete = logs.errors.empty() && !calibrator_.report().file_error;
  if (outcome.cause == EndCause::done && !complete) outcome.cause = EndCause::files_lost;
  return outcome;
}

// Where the process ends with its run. A service that stays beyond its run is taken for one that hangs.
void Run::watch_after(const RunOutcome& outcome, const LogReport& logs, const sigset_t& signals) {
  const bool ended = outcome.cause == EndCause::done || outcome.cause == EndCause::run_stopped;
  if (config_.at_end == config::AtEnd::stay || !ended || !logs.last_driven_record) return;
  if (options_.as_service) {
    if (config_.gap_watch != config::GapWatch::off)
      spdlog::warn("gap.watch: a service looks at its drives with run.at_end 'stay' only");
    return;
  }
  watch_.drive_ended(logs.recalibration_due);
  watch_.wait(signals);
}

void Run::start_all() {
  try {
    start_loop();
    log_setup();
    start_threads();
  } catch (const std::system_error& error) {
    end_loop();
    end_threads("not started");
    throw StartFailure(EndCause::internal, std::string("no thread left: ") + error.what() +
                                               "; raise the limit of threads (ulimit -u, TasksMax=)");
  }
}

RunOutcome Run::supervise(const sigset_t& signals) {
  try {
    return Supervisor(
               {config_, options_, sensor_loop_, guardian_, *wiring_, board_, real_time_, folder_, watch_},
               service_)
        .run(signals);
  } catch (const std::exception& error) {
    return {EndCause::internal, std::string("the supervisor has ended: ") + error.what(), {}, true};
  }
}

// The real-time rights are settled before anything moves.
void Run::start_loop() {
  loop_ = std::thread([this] {
    name_thread("ww-loop");
    set_up_loop_thread(config_.real_time, real_time_);
    const bool refused =
        config_.real_time.policy == config::RealTimePolicy::require && !real_time_.shortfall.empty();
    scheduled_.store(refused ? -1 : 1);
    scheduled_.notify_one();
    try {
      if (!refused) sensor_loop_.run();
    } catch (const std::exception& error) {
      loop_failed_.store(true);
      wiring_->failure.report(std::string("the sensor loop has ended: ") + error.what());
    }
    loop_ended_.store(true);
  });
  scheduled_.wait(0);
  if (scheduled_.load() > 0) return;
  loop_.join();
  throw StartFailure(EndCause::no_permission,
                     config_.file.string() + ": real_time.policy is 'require', but " + real_time_.shortfall);
}

void Run::log_setup() {
  guardian_.set_patience(guardian_patience(config_.link, real_time_.priority > 0));
  spdlog::info("{}: {}{}", config_.device.string(), describe(real_time_),
               port_.low_latency ? ", low-latency port" : "");
  if (!real_time_.shortfall.empty()) spdlog::warn("{}", real_time_.shortfall);
  if (port_.latency_timer_ms && *port_.latency_timer_ms > 2) {
    spdlog::warn("the adapter holds data for {} ms; systemd/ has the udev rule that sets 1 ms",
                 *port_.latency_timer_ms);
  }
}

void Run::start_threads() {
  threads_.push_back(start_thread("ww-predict", *wiring_, [this] {
    set_up_predictor_thread(real_time_);
    run_predictor(brain_, *wiring_, sensor_loop_);
  }));
  threads_.push_back(start_thread("ww-calibrate", *wiring_, [this] { calibrator_.run(); }));
  log_thread_ = start_thread("ww-log", *wiring_, [this] { log_.run(); });
  live_view_thread_ = start_thread("ww-live-view", *wiring_, [this] { live_view_.run(); });
}

// Before the other threads, since it holds the wheels.
void Run::end_loop() {
  sensor_loop_.request_end();
  if (loop_.joinable()) {
    if (!loop_ends()) abandon_loop();
    loop_.join();
  }
  if (loop_failed_.load()) guardian_.leave_wheels_to_guardian();
}

// Those that were started.
void Run::end_threads(const std::string& result) {
  wiring_->ending.store(true);
  wiring_->frame_arrived.release();
  for (std::thread& thread : threads_) thread.join();
  if (log_thread_.joinable()) log_thread_.join();
  if (!live_view_thread_.joinable()) return;
  live_view_.end(result, result == finished ? route_in_words(config_, log_.report()) : "");
  live_view_thread_.join();
}

bool Run::loop_ends() const {
  const auto until = std::chrono::steady_clock::now() + loop_patience;
  while (!loop_ended_.load() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return loop_ended_.load();
}

// Nothing can be ended in order any more but the logs.
void Run::abandon_loop() {
  guardian_.leave_wheels_to_guardian();
  spdlog::critical("the sensor loop hangs and does not end; the guardian puts the wheels to rest");
  wiring_->ending.store(true);
  wiring_->frame_arrived.release();
  if (log_thread_.joinable()) log_thread_.join();
  drain_messages();
  ::_exit(exit_status(EndCause::internal, options_.as_service));
}

// The same text in the folder of the run and, where one was asked for, in a file elsewhere.
void Run::write_lateness(LogReport& logs) const {
  const std::string text = lateness_text(lateness_record(sensor_loop_.lateness(), sensor_loop_.counts(),
                                                         config_.link.period_s, describe(real_time_)));
  const auto write = [&](const std::filesystem::path& file) {
    if (const auto error = config::write_output({file, config::OutputKind::lateness}, text)) {
      spdlog::error("{}", *error);
      logs.errors.push_back(*error);
    } else {
      logs.files.push_back(file);
    }
  };
  write(folder_ / lateness_file_name);
  if (!options_.lateness_file.empty()) write(options_.lateness_file);
}

}  // namespace wheelwright::daemon

#include "daemon/supervisor.hpp"

#include <spdlog/spdlog.h>
#include <time.h>

#include <csignal>

#include "config/load/output_file.hpp"
#include "daemon/wiring/plan.hpp"

namespace wheelwright::daemon {
namespace {

using namespace std::chrono_literals;

constexpr auto answer_patience = 15s;
constexpr auto linger_after_end = 500ms;   // the robot comes to rest, and the log gets to see it
constexpr auto lost_robot_patience = 60s;  // for it to be plugged in again
constexpr auto report_interval = 1s;
constexpr auto long_enough = 60s;  // for a process to be no part of a row of failures
constexpr long look_every_ns = 50'000'000;

EndCause cause_of(StopReason reason) {
  const bool silent = reason == StopReason::blind || reason == StopReason::link_lost;
  return silent ? EndCause::robot_silent : EndCause::run_stopped;
}

}  // namespace

RunOutcome Supervisor::run(const sigset_t& signals) {
  sigset_t awaited = signals;
  ::sigaddset(&awaited, SIGCHLD);  // the end of the guardian is heard at once
  const timespec patience{0, look_every_ns};
  while (true) {
    const int signal = ::sigtimedwait(&awaited, nullptr, &patience);
    if (auto end = obey(signal)) return *end;
    arm_when_ready();
    if (auto end = next_run()) return *end;
    if (auto end = end_of_run()) return *end;
    report_status(Clock::now());
  }
}

std::optional<RunOutcome> Supervisor::obey(int signal) {
  switch (signal) {
    case SIGTERM:
    case SIGINT:
      return ended_by_signal("ended by a signal");
    case SIGXCPU:
      return ended_by_signal("a limit of processor time is reached (ulimit -t, LimitCPU=)");
    case SIGUSR1:
      return arm_or_begin_next_run();
    case SIGUSR2:
      armed_once_ = true;  // an arming that is still to come is taken back
      stop_asked_ = true;
      parts_.sensor_loop.request_stop(StopReason::requested);
      return std::nullopt;
    case SIGHUP:
      if (service_.from_terminal) return ended_by_signal("the terminal was closed");
      return reload();
    default:
      return std::nullopt;
  }
}

// What the robot is doing is not known to be nothing as long as it is armed and not at the end of its run.
bool Supervisor::moves() const {
  const auto latest = parts_.board.latest();
  return latest && latest->frame.armed && latest->frame.command.activity != Activity::finished;
}

// Of a run that ended, the logs are whole: the next one has files of its own. A robot that was lost has to
// answer first, and one that was told to stand to do so.
std::optional<RunOutcome> Supervisor::arm_or_begin_next_run() {
  const bool has_ended =
      stop_asked_ || parts_.wiring.finished.load() || parts_.wiring.stop.load() != StopReason::none;
  if (has_ended && parts_.wiring.robot_is_connected.load() && parts_.board.latest()) {
    next_run_wanted_ = true;
    return next_run();
  }
  armed_once_ = true;
  arm();
  return std::nullopt;
}

std::optional<RunOutcome> Supervisor::next_run() {
  const bool has_ended = parts_.wiring.finished.load() || parts_.wiring.stop.load() != StopReason::none;
  if (!next_run_wanted_ || !has_ended || moves() || !parts_.wiring.robot_is_connected.load())
    return std::nullopt;
  RunOutcome outcome = parts_.wiring.finished.load() ? RunOutcome{} : ended_early();
  outcome.reload = parts_.config;
  outcome.arms_next_run = true;
  return outcome;
}

// All of a configuration may change, since all is built again from it; but not under a robot that drives.
std::optional<RunOutcome> Supervisor::reload() {
  if (moves()) {
    spdlog::error("not reloaded: the robot drives; stop it first (SIGUSR2)");
    return std::nullopt;
  }
  try {
    RunOutcome outcome{EndCause::asked, "the configuration is loaded again", {}, false};
    outcome.reload = load_configuration(parts_.options);
    make_plan(*outcome.reload, known_model(*outcome.reload));
    return outcome;
  } catch (const std::exception& error) {
    spdlog::error("not reloaded: {}", error.what());
    return std::nullopt;
  }
}

RunOutcome Supervisor::ended_early() const {
  const StopReason reason = parts_.wiring.stop.load();
  return {cause_of(reason), std::string(name_of(reason)), {}, false};
}

RunOutcome Supervisor::ended_by_signal(const std::string& why) const {
  if (lost_since_) return ended_early();
  if (parts_.wiring.finished.load() && !moves()) return {};
  return {EndCause::asked, why, {}, moves()};
}

std::optional<RunOutcome> Supervisor::end_of_run() {
  const auto now = Clock::now();
  if (!parts_.guardian.alive())
    return RunOutcome{EndCause::internal, "the guardian process has ended", {}, true};
  if (!parts_.guardian.responds()) {
    return RunOutcome{EndCause::internal, "the guardian process stands still", {}, true};
  }
  if (auto failure = parts_.wiring.failure.what()) return RunOutcome{EndCause::internal, *failure, {}, true};
  if (parts_.config.at_end == config::AtEnd::stay) return std::nullopt;
  const bool finished = parts_.wiring.finished.load();
  const bool over = finished || parts_.wiring.stop.load() != StopReason::none;
  if (!over) not_over_ = now;
  if (over && now - not_over_ >= linger_after_end && !waits_for_lost_robot(now))
    return finished ? RunOutcome{} : ended_early();
  // As a service it is waited for; the status line says so.
  if (!parts_.options.as_service && now - started_ > answer_patience && !parts_.wiring.robot_answers.load()) {
    return RunOutcome{
        EndCause::robot_silent,
        "the robot does not answer on " + parts_.config.device.string() + "; try 'wheelwright doctor'",
        {},
        true};
  }
  return std::nullopt;
}

// A robot whose cable is out drives on by its last command. The link goes on looking for it, and tells it to
// stand as soon as it answers; a process that ended could not. A service is started again for that.
bool Supervisor::waits_for_lost_robot(Clock::time_point now) {
  if (parts_.options.as_service || !armed_once_ || ended_early().cause != EndCause::robot_silent)
    return false;
  const auto latest = parts_.board.latest();
  if (latest && latest->frame.valid) {
    if (lost_since_) spdlog::info("the robot answers again, and its wheels are told to stand");
    lost_since_.reset();
    return false;
  }
  if (parts_.wiring.robot_is_connected.load()) {  // as far as the link knows by now
    const auto decided =
        std::chrono::duration<double>(parts_.config.link.lost_after_s) + 2 * linger_after_end;
    return now - not_over_ < decided;
  }
  if (!lost_since_) {
    lost_since_ = now;
    spdlog::error(
        "the robot may still drive: lift it or plug it in again. Its wheels are told to stand as soon as it "
        "answers; that is tried for {} s, Ctrl-C ends it at once",
        lost_robot_patience.count());
  }
  return now - *lost_since_ < lost_robot_patience;
}

void Supervisor::arm_when_ready() {
  const bool wanted = parts_.config.arm_at_start || service_.arms_next_run;
  if (armed_once_ || !wanted || !parts_.wiring.robot_answers.load()) return;
  armed_once_ = true;
  if (service_.hold) {
    spdlog::warn("not armed: {}; SIGUSR1 arms the robot", *service_.hold);
    return;
  }
  arm();
}

// Not before the note of it is on the disk: a process that comes after a power cut has nothing else to go by.
void Supervisor::arm() {
  if (const auto error = service_.restarts.armed()) {
    spdlog::error("not armed: {}", *error);
    return;
  }
  parts_.sensor_loop.request_arm();
}

// Where the process ends with its run, the run itself sees to it.
void Supervisor::watch_model() {
  const bool moves_now = moves();
  if (moved_ && !moves_now && parts_.config.at_end == config::AtEnd::stay) {
    const auto latest = parts_.board.latest();
    parts_.watch.drive_ended(latest && latest->record.hybrid && latest->record.hybrid->recalibration_due);
  }
  moved_ = moves_now;
  parts_.watch.look();
}

void Supervisor::report_status(Clock::time_point now) {
  service_.notifier.feed(parts_.sensor_loop.counts().ticks);
  if (parts_.wiring.robot_answers.load()) service_.notifier.ready();
  if (now - last_report_ < report_interval) return;
  last_report_ = now;
  watch_model();
  if (now - started_ > long_enough) service_.restarts.lasted();
  const StatusView view{parts_.config,        parts_.sensor_loop,    parts_.real_time,
                        parts_.run_folder,    parts_.board.latest(), parts_.wiring.robot_answers.load(),
                        parts_.watch.answer()};
  service_.notifier.status(status_line(view));
  if (parts_.options.status_file.empty()) return;
  const auto error =
      config::write_output({parts_.options.status_file, config::OutputKind::status}, status_json(view));
  if (error && !status_failed_) spdlog::error("{}", *error);
  status_failed_ = error.has_value();
}

}  // namespace wheelwright::daemon

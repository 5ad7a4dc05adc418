// The main thread while the others work: signals, the first arming, the end of the run, and what the service
// manager and `wheelwright status` are told.
#pragma once

#include <sys/signal.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "config/load/daemon_config.hpp"
#include "daemon/guardian/guardian_handle.hpp"
#include "daemon/model_watch/model_watch.hpp"
#include "daemon/process.hpp"
#include "daemon/service/exit_status.hpp"
#include "daemon/telemetry/status_file.hpp"
#include "daemon/threads/real_time_setup.hpp"
#include "daemon/wiring/status_board.hpp"
#include "daemon/wiring/wiring.hpp"
#include "drivers/roomba/sensor_loop.hpp"

namespace wheelwright::daemon {

struct RunOutcome {
  EndCause cause = EndCause::done;
  std::string stopped;                         // why, where it did not finish
  std::optional<config::DaemonConfig> reload;  // go on with this one, in the same process
  bool interrupted = false;                    // the robot drove, or could not be reached at the end
  bool left_at_rest = false;                   // the robot was told so at the end, in Off mode
  bool arms_next_run = false;                  // which begins with `reload`

  bool finished() const { return cause == EndCause::done; }
};

// What it watches over; all of it outlives the supervisor.
struct Supervised {
  const config::DaemonConfig& config;
  const ProcessOptions& options;
  roomba::SensorLoop& sensor_loop;
  GuardianHandle& guardian;
  Wiring& wiring;
  const StatusBoard& board;
  const RealTimeStatus& real_time;
  std::filesystem::path run_folder;
  ModelWatch& watch;
};

class Supervisor {
 public:
  Supervisor(Supervised parts, Service& service) : parts_(std::move(parts)), service_(service) {}

  // Returns when the run is to end. `signals` and SIGCHLD are blocked in every thread.
  RunOutcome run(const sigset_t& signals);

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<RunOutcome> obey(int signal);
  std::optional<RunOutcome> end_of_run();
  std::optional<RunOutcome> reload();
  std::optional<RunOutcome> arm_or_begin_next_run();
  std::optional<RunOutcome> next_run();
  RunOutcome ended_early() const;
  RunOutcome ended_by_signal(const std::string& why) const;
  void arm();
  bool moves() const;
  void arm_when_ready();
  bool waits_for_lost_robot(Clock::time_point now);
  void report_status(Clock::time_point now);
  void watch_model();

  Supervised parts_;
  Service& service_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point not_over_ = started_;
  Clock::time_point last_report_{};
  std::optional<Clock::time_point> lost_since_{};  // a robot that drove, and is looked for
  bool armed_once_ = false;
  bool stop_asked_ = false;       // of the run
  bool next_run_wanted_ = false;  // as soon as this one has ended
  bool status_failed_ = false;
  bool moved_ = false;  // when it was looked at last
};

}  // namespace wheelwright::daemon

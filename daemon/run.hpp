// One run of the daemon: its parts, its threads, and its folder, from the plan to the summary.
#pragma once

#include <sys/signal.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "config/load/daemon_config.hpp"
#include "daemon/guardian/guardian_handle.hpp"
#include "daemon/guardian/open_device.hpp"
#include "daemon/model_watch/model_watch.hpp"
#include "daemon/process.hpp"
#include "daemon/supervisor.hpp"
#include "daemon/telemetry/live_view.hpp"
#include "daemon/threads/calibrator_thread.hpp"
#include "daemon/threads/log_thread.hpp"
#include "daemon/threads/real_time_setup.hpp"
#include "daemon/threads/ring_client.hpp"
#include "daemon/wiring/plan.hpp"
#include "daemon/wiring/status_board.hpp"
#include "daemon/wiring/wiring.hpp"
#include "drivers/roomba/sensor_loop.hpp"
#include "model/brain/brain.hpp"

namespace wheelwright::daemon {

class Run {
 public:
  // Opens the robot's port and makes the folder of the run; nothing moves yet. All arguments outlive the run.
  // Throws StartFailure or ConfigError where it cannot start.
  Run(const config::DaemonConfig& config, const ProcessOptions& options, Service& service);

  // Starts the threads, waits for the end, ends them, and prints the summary. Throws StartFailure where
  // real-time scheduling is required and not to be had, or the system has no thread left. Where the sensor
  // loop hangs at the end, the process ends here, and its guardian puts the wheels to rest. `signals` are
  // blocked in every thread.
  RunOutcome drive(const sigset_t& signals);

 private:
  void keep_inputs();
  void start_loop();
  void log_setup();
  void start_threads();
  void watch_after(const RunOutcome& outcome, const LogReport& logs, const sigset_t& signals);
  void start_all();
  RunOutcome supervise(const sigset_t& signals);
  void end_loop();
  void end_threads(const std::string& result);
  bool loop_ends() const;
  [[noreturn]] void abandon_loop();
  void write_lateness(LogReport& logs) const;

  // In the order in which they come; they go the other way round.
  const config::DaemonConfig& config_;
  const ProcessOptions& options_;
  Service& service_;
  Plan plan_;
  GuardianHandle guardian_;
  serial::OpenPort port_;
  std::filesystem::path folder_;
  RealTimeStatus real_time_;
  std::unique_ptr<Wiring> wiring_;
  RingClient client_;
  roomba::SensorLoop sensor_loop_;
  Brain brain_;
  CalibratorThread calibrator_;
  StatusBoard board_;
  LogThread log_;
  telemetry::LiveView live_view_;
  ModelWatch watch_;
  std::vector<std::string> inputs_lost_;  // why, each
  std::atomic<int> scheduled_{0};         // the loop: 0 not yet, 1 goes, -1 may not
  std::atomic<bool> loop_ended_{false};
  std::atomic<bool> loop_failed_{false};
  std::thread loop_;
  std::vector<std::thread> threads_;  // predictor, calibrator
  std::thread log_thread_;
  std::thread live_view_thread_;
};

}  // namespace wheelwright::daemon

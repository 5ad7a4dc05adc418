// The thread that writes: drive log, pose log, the same as MCAP where it is wanted, the daemon's messages,
// and after a stop that nobody asked for the last 250 ticks.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "config/load/daemon_config.hpp"
#include "daemon/recording/growing_file.hpp"
#include "daemon/recording/mcap_log.hpp"
#include "daemon/wiring/status_board.hpp"
#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon {

// What was written, and what the run came to, for the summary.
struct LogReport {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> errors;
  std::uint64_t lost_lines = 0;
  std::uint64_t lost_messages = 0;  // of the MCAP file
  std::optional<PoseRecord> last_driven_record;
  std::int64_t logged_ticks = 0;
  std::uint64_t faults = 0;        // that the hybrid filter found
  bool recalibration_due = false;  // as it said at last
  double route_length_m = 0.0;     // as predicted
  // How far the model and the filter put the robot apart at last, where their uncertainties exclude that.
  std::optional<double> apart_m;
};

class LogThread {
 public:
  // `folder` is the folder of this run; it exists.
  LogThread(const config::DaemonConfig& config, std::filesystem::path folder,
            const WheelPair& metres_per_tick, Wiring& wiring, StatusBoard& board);

  // Runs until wiring.ending, then empties its rings and closes the files.
  void run();

  // Valid after run() has returned.
  const LogReport& report() const { return report_; }

 private:
  static constexpr std::size_t recorder_ticks = 250;

  void drain();
  void take(const LogEntry& entry);
  void tell(const roomba::Event& event);
  void tell_of_link(const roomba::Event& event);
  void tell_of_drive(const roomba::Event& event);
  void note_activity(const LogEntry& entry);
  void note_faults(const PoseRecord& record);
  void note_disagreement(const PoseRecord& record);
  void note_file_errors();
  void write_flight_recorder(StopReason reason);
  void finish();

  const config::DaemonConfig& config_;
  std::filesystem::path folder_;
  WheelPair metres_per_tick_;
  Wiring& wiring_;
  StatusBoard& board_;
  GrowingFile drive_log_;
  GrowingFile pose_log_;
  std::optional<McapLog> mcap_log_;  // where it is wanted
  std::vector<LogEntry> recorder_;
  std::size_t recorder_next_ = 0;
  StopReason last_stop_ = StopReason::none;
  Activity last_activity_ = Activity::idle;
  int apart_ticks_ = 0;         // in a row
  bool run_has_begun_ = false;  // what stops a robot before it is armed is no part of a run
  LogReport report_;
};

}  // namespace wheelwright::daemon

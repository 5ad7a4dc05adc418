// run.mcap: what drive log and pose log hold, as MCAP, written while the run goes on.
#pragma once

#include <chrono>
#include <filesystem>

#include "config/load/daemon_config.hpp"
#include "daemon/recording/growing_file.hpp"
#include "daemon/recording/mcap/robot_recording.hpp"
#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon {

// An entry of the logs as the MCAP file has it.
mcap::TickValues tick_values(const LogEntry& entry);

class McapLog {
 public:
  // Creates the file; file().error() says why where that fails.
  McapLog(const config::DaemonConfig& config, const std::filesystem::path& path);

  void take(const LogEntry& entry) { recording_.add(tick_values(entry)); }
  // Hands what was taken to the disk, a chunk a second: a power cut costs one or two of them and no more.
  void flush(std::chrono::steady_clock::time_point now);
  // Ends the file. Returns how many messages found no room.
  std::uint64_t close();

  const GrowingFile& file() const { return file_; }

 private:
  GrowingFile file_;
  mcap::RobotRecording recording_;
  std::chrono::steady_clock::time_point next_chunk_{};
};

}  // namespace wheelwright::daemon

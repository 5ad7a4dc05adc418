// One test's bench: a folder of its own, a simulated robot, and a daemon to drive it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/loopback/bench/child_process.hpp"
#include "tests/loopback/bench/eventually.hpp"
#include "tests/loopback/bench/table.hpp"
#include "tests/support/temporary_folder.hpp"

namespace wheelwright::bench {

using namespace std::chrono_literals;

// What a test wants of the daemon. The texts are further keys of their sections, in YAML flow style.
struct DaemonSetup {
  std::string device = "robot";  // in the bench's folder
  std::string link = {};
  std::string limits = {};
  std::string calibration = "when: never";
  std::string run = {};
  std::string live_view = "port: 0";
  bool has_model = true;              // one that says that a wheel follows within 0.13 s with gain 1
  std::string route = "[[0.25, 0]]";  // checkpoints; empty for none
  double speed_m_s = 0.2;
};

class Bench {
 public:
  const std::filesystem::path& folder() const { return folder_.path(); }
  std::filesystem::path device() const { return folder() / "robot"; }
  std::filesystem::path truth_file() const { return folder() / "truth.csv"; }

  std::filesystem::path write(const std::string& name, const std::string& text) const;

  // Starts roomba-sim: a shipped robot with the keys of `changes` (YAML, block style) in place of its own.
  std::unique_ptr<ChildProcess> start_robot(const std::string& shipped, const std::string& changes = "",
                                            const std::vector<std::string>& options = {});
  // Writes the daemon's configuration.
  std::filesystem::path configure(const DaemonSetup& setup) const;
  // Starts wheelwrightd; `wrapper` is put in front of the command, `options` behind it.
  std::unique_ptr<ChildProcess> start_daemon(const std::filesystem::path& config,
                                             const std::vector<std::string>& wrapper = {},
                                             const std::vector<std::string>& options = {}) const;

  // Folders of the daemon's runs so far, oldest first.
  std::vector<std::filesystem::path> runs() const;
  Table drive_log() const { return Table::load(runs().back() / "drive_log.csv"); }
  Table pose_log() const { return Table::load(runs().back() / "pose_log.csv"); }
  // What the simulated robot truly did; complete once it has ended.
  Table truth() const { return Table::load(truth_file()); }

 private:
  test::TemporaryFolder folder_{"loopback"};
};

// How the replies came, as the daemon's summary counts them.
struct Replies {
  int sound = 0, asked = 0, missing = 0, incomplete = 0, garbled = 0;
};
Replies replies_of(const std::string& summary);

// Ticks that the loop left out because it woke up late, as the daemon's summary counts them.
int skipped_periods_of(const std::string& summary);

// How far the wheels went on the floor, in metres, as the truth file says.
struct Travel {
  double left_m = 0.0;
  double right_m = 0.0;
};
Travel travel_of(const Table& truth);

// Says on the terminal that a test does nothing here, and why.
void skip(const std::string& why);

}  // namespace wheelwright::bench

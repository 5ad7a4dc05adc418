// The watch over a model: after a drive the gap workflow runs on what the robot has recorded since its model
// was made, and says what has changed.
//
// `wheelwright gap` is a process of its own, at the lowest priority and within 100 MB, so that no tick of the
// loop waits for it. Its answer is in the folder of the run (gap/). A new model takes the place of the model
// file where it is proven on drives that it has not seen, which takes four drives; the former one is kept
// as gap/former_model.yaml. The daemon drives by the new model from the next start, or the next SIGHUP, on.
// What notices a changed floor during a drive is model/filter/environment_monitor.hpp.
#pragma once

#include <sys/signal.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/load/daemon_config.hpp"
#include "daemon/model_watch/idle_process.hpp"
#include "daemon/model_watch/model_changes.hpp"

namespace wheelwright::daemon {

class ModelWatch {
 public:
  // Both outlive the watch.
  ModelWatch(const config::DaemonConfig& config, const std::filesystem::path& run_folder,
             const IdleProcessLimits& limits = {})
      : config_(config), run_folder_(run_folder), limits_(limits) {}

  // A drive has ended. Begins where the configuration (gap.watch) wants it, and a former search has ended.
  void drive_ended(bool recalibration_due);
  // Says what came of a search that has ended; never blocks.
  void look();
  // Waits until the search has ended, or one of `signals` comes.
  void wait(const sigset_t& signals);

  // The last answer in one line; empty before there is one.
  const std::string& answer() const { return answer_; }

 private:
  void begin();
  void say(const std::string& answer);
  void report(const RobotModel& before);
  void take_up(const RobotModel& before, const RobotModel& after, const GapAnswer& answer);

  const config::DaemonConfig& config_;
  const std::filesystem::path& run_folder_;
  IdleProcessLimits limits_;
  std::unique_ptr<IdleProcess> search_;
  std::vector<std::filesystem::path> drives_;
  std::string answer_;
};

}  // namespace wheelwright::daemon

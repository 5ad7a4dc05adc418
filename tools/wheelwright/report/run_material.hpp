// What a report is made from: the files of a run, and the calibrations fitted again from its log, so that
// their figures can be drawn.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/load/daemon_config.hpp"
#include "daemon/recording/lateness_file.hpp"
#include "daemon/recording/mcap/robot_recording.hpp"
#include "model/brain/calibrator.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::tools {

// The calibrations of a run, as the daemon's calibrator makes them of the same frames.
struct CalibrationMaterial {
  std::vector<TurnSample> turn;  // in place
  std::optional<EncoderScaleFit> scale;
  std::vector<DriveLog> responses;  // one per wheel and repetition
  std::optional<FirFit> fir;
  DriveLog random;  // the random drive
  std::optional<ArmaFit> arma;
  std::vector<std::string> refusals;
  std::optional<RobotModel> model;  // that came of it

  bool empty() const { return turn.empty() && responses.empty() && random.samples.empty(); }
};

struct RunMaterial {
  std::string name;                     // of the folder or file, for the title
  std::optional<DriveLog> drive;        // drive log
  std::vector<mcap::TickValues> ticks;  // drive log and pose log together
  std::map<std::string, std::string> metadata;
  std::optional<config::DaemonConfig> config;
  std::optional<RobotModel> model;  // that the run was driven by, as far as the files tell
  CalibrationMaterial calibration;
  std::optional<daemon::LatenessRecord> lateness;  // of the sensor loop, where the run came to its end
};

// `path` is the folder of a run or a drive log or a pose log; `model` is looked at instead of the folder's
// own where it is given. Throws config::LogError, config::ConfigError or UsageError.
RunMaterial load_run_material(const std::filesystem::path& path, const std::optional<RobotModel>& model);

}  // namespace wheelwright::tools

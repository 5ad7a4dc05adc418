// The thread that fits: it takes as long as it takes, while the robot stands and the loop goes on.
#pragma once

#include <optional>

#include "config/load/daemon_config.hpp"
#include "daemon/wiring.hpp"

namespace wheelwright::daemon {

// What the calibrations gave, for the summary.
struct CalibrationReport {
  std::optional<bool> encoders_swapped;
  std::optional<EncoderScaleFit> encoder_scale;
  std::optional<RobotModel> model;
  std::optional<std::string> refusal;
  std::optional<std::string> file_error;  // the model could not be written
};

class CalibratorThread {
 public:
  CalibratorThread(const config::DaemonConfig& config, const Mission& mission, roomba::Session& session,
                   Wiring& wiring);

  // Runs until wiring.ending.
  void run();

  // Valid after run() has returned.
  const CalibrationReport& report() const { return report_; }

 private:
  void deliver(CalibrationOutcome& outcome);
  void deliver_encoder_order(bool swapped);
  void deliver_response(CalibrationOutcome& outcome);
  void deliver_arma(CalibrationOutcome& outcome);
  void keep_model(RobotModel model);
  void hand_over(CalibrationKind kind, const RobotModel& model);

  const config::DaemonConfig& config_;
  Mission mission_;
  Calibrator calibrator_;
  roomba::Session& session_;
  Wiring& wiring_;
  CalibrationReport report_;
};

// Date and time now, ISO 8601 in UTC.
std::string utc_now();

}  // namespace wheelwright::daemon

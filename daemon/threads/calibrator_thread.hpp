// The thread that fits: it takes as long as it takes, while the loop goes on. Each model that it makes while
// a route is driven becomes a file of its own in the folder of the run, before it is driven by: model-2.yaml,
// model-3.yaml, and so on.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "config/load/daemon_config.hpp"
#include "daemon/wiring/plan.hpp"
#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon {

// What the calibrations gave, for the summary.
struct CalibrationReport {
  std::optional<bool> encoders_swapped;
  std::optional<EncoderScaleFit> encoder_scale;
  std::optional<RobotModel> model;
  std::optional<std::string> refusal;
  std::optional<std::string> route_refusal;    // of the model that was made
  std::vector<std::string> remarks;            // for a person to look at
  std::optional<std::string> late_readings;    // of the last response or random drive
  std::optional<std::string> file_error;       // the model could not be written
  std::vector<std::filesystem::path> adapted;  // models made while driving, in order
};

class CalibratorThread {
 public:
  // `folder` is the folder of this run; it exists.
  CalibratorThread(const config::DaemonConfig& config, const Plan& plan, std::filesystem::path folder,
                   roomba::SensorLoop& sensor_loop, Wiring& wiring);

  // Runs until wiring.ending.
  void run();

  // Valid after run() has returned.
  const CalibrationReport& report() const { return report_; }

 private:
  void deliver(CalibrationOutcome& outcome);
  void deliver_encoder_order(bool swapped);
  void deliver_response(CalibrationOutcome& outcome);
  void deliver_arma(CalibrationOutcome& outcome);
  void deliver_adaptation(CalibrationOutcome& outcome);
  void note(std::optional<std::string> remark);
  void keep_model(RobotModel model);
  void write_model(const RobotModel& model, const std::filesystem::path& path);
  void hand_over(Delivery delivery, const RobotModel& model);

  const config::DaemonConfig& config_;
  Mission mission_;
  std::filesystem::path folder_;
  Calibrator calibrator_;
  roomba::SensorLoop& sensor_loop_;
  Wiring& wiring_;
  CalibrationReport report_;
};

}  // namespace wheelwright::daemon

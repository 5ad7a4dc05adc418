// Collects what the calibration manoeuvres show, and fits it; and while a route is driven, holds the model
// against it and makes a better one where it has become wrong. Runs beside the brain, not in it: a fit takes
// as long as it takes, while the brain goes on ticking.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/adaptation/continuous_calibration.hpp"
#include "model/brain/mission.hpp"
#include "model/calibration/punctuality.hpp"
#include "model/identification/arma_fit.hpp"
#include "model/identification/fir_fit.hpp"
#include "model/log/drive_log.hpp"
#include "model/log/sensor_frame.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

enum class CalibrationKind : std::uint8_t { encoder_order, encoder_scale, response, arma, adaptation };

// A model that was adapted while driving, and why it is better: root mean square of how far its free run of
// 2 s is off the encoders, on driving that it has not seen (model/adaptation/model_trial.hpp).
struct AdaptedModel {
  std::int64_t found_tick = 0;
  std::int64_t from_tick = 0;  // to be driven by from here on
  std::uint16_t version = 2;   // the model that the run began with is 1
  double error_before_m = 0.0;
  double error_m = 0.0;
};

// What came of a calibration. Either `refusal` or the part that belongs to the kind is there.
struct CalibrationOutcome {
  CalibrationKind kind{};
  std::optional<Refusal> refusal;
  bool encoders_swapped = false;                 // encoder_order
  std::optional<EncoderScaleFit> encoder_scale;  // encoder_scale
  std::optional<FirFit> response;                // response
  std::optional<ArmaFit> arma;                   // arma
  std::optional<AdaptedModel> adapted;           // adaptation
  std::optional<std::string> remark;             // response, arma: what was left out of it
  std::optional<RobotModel> model;               // response, arma, adaptation: all that is known, to drive by
  std::optional<Refusal> route_refusal;  // the model is sound, and yet the route is not to be driven by it
};

class Calibrator {
 public:
  // `model` is what the run begins with, where it does not calibrate first.
  Calibrator(const Mission& mission, const RobotLimits& limits, const std::optional<RobotModel>& model);

  // Takes each frame in order. Returns an outcome when a manoeuvre is complete and fitted, or a better model
  // was found on the way.
  std::optional<CalibrationOutcome> take(const SensorFrame& frame);

  // The recordings of the response actions, one per wheel and repetition.
  const std::vector<DriveLog>& response_runs() const { return response_runs_; }
  // The recording of the random drive.
  const DriveLog& random_run() const { return random_run_; }
  const std::vector<TurnSample>& turn_samples() const { return turn_samples_; }

 private:
  std::optional<CalibrationOutcome> take_manoeuvre(const SensorFrame& frame, bool entered);
  std::optional<CalibrationOutcome> adapt(const SensorFrame& frame, Activity before);
  void watch(const std::optional<RobotModel>& model);
  void note_counts(const SensorFrame& frame, bool entered, bool recorded_before);
  std::optional<Refusal> doubt_of_counts() const;
  std::optional<Refusal> doubt_of_manoeuvre() const;
  void record_response(const SensorFrame& frame);
  CalibrationOutcome encoder_order() const;
  CalibrationOutcome encoder_scale();
  void begin_random(const SensorFrame& frame);
  void record_random(const SensorFrame& frame);
  CalibrationOutcome response() const;
  CalibrationOutcome arma() const;
  DriveLog new_run(std::string name) const;
  RobotModel model_of(const LinearModel& linear_part, const WheelFit& left, const WheelFit& right,
                      std::string source) const;

  Mission mission_;
  RobotLimits limits_;
  WheelPair metres_per_tick_;
  std::optional<EncoderScale> encoder_scale_;
  std::optional<WheelTicks> check_start_;
  WheelTicks check_end_;
  std::vector<TurnSample> turn_samples_;
  std::vector<DriveLog> response_runs_;
  std::vector<std::vector<WheelTicks>> response_counts_;  // as the robot counted, one per sample
  std::int64_t response_start_tick_ = 0;
  DriveLog random_run_;
  std::vector<WheelTicks> random_counts_;
  std::int64_t random_start_tick_ = 0;
  std::optional<ContinuousCalibration> continuous_;
  std::uint16_t model_version_ = 1;
  Activity last_activity_ = Activity::idle;
  Punctuality punctuality_;
  int refused_counts_ = 0;     // readings of the manoeuvre whose counts no wheel can have made
  bool counts_broke_ = false;  // in the manoeuvre: they got a new origin on the way
};

}  // namespace wheelwright

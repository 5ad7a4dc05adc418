// Collects what the calibration manoeuvres show, and fits it. Runs beside the brain, not in it: a fit takes
// as long as it takes, while the robot stands and the brain goes on ticking.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/brain/mission.hpp"
#include "model/drive_log.hpp"
#include "model/identification/arx_fit.hpp"
#include "model/identification/fir_fit.hpp"
#include "model/robot_model.hpp"
#include "model/sensor_frame.hpp"

namespace wheelwright {

enum class CalibrationKind : std::uint8_t { encoder_order, encoder_scale, response, arma };

// What came of a calibration. Either `refusal` or the part that belongs to the kind is there.
struct CalibrationOutcome {
  CalibrationKind kind{};
  std::optional<Refusal> refusal;
  bool encoders_swapped = false;                 // encoder_order
  std::optional<EncoderScaleFit> encoder_scale;  // encoder_scale
  std::optional<FirFit> response;                // response
  std::optional<ArxFit> arma;                    // arma
  std::optional<RobotModel> model;               // response, arma: all that was found, to drive by
};

class Calibrator {
 public:
  Calibrator(const Mission& mission, const RobotLimits& limits);

  // Takes each frame in order. Returns an outcome when a manoeuvre is complete and fitted.
  std::optional<CalibrationOutcome> take(const SensorFrame& frame);

  // The recordings of the response actions, one per wheel and repetition.
  const std::vector<DriveLog>& response_runs() const { return response_runs_; }
  // The recording of the random drive.
  const DriveLog& random_run() const { return random_run_; }
  const std::vector<TurnSample>& turn_samples() const { return turn_samples_; }

 private:
  void record_response(const SensorFrame& frame);
  CalibrationOutcome encoder_order() const;
  CalibrationOutcome encoder_scale();
  void begin_random(const SensorFrame& frame);
  void record_random(const SensorFrame& frame);
  CalibrationOutcome response() const;
  CalibrationOutcome arma() const;
  DriveLog new_run(std::string name) const;
  RobotModel model_of(const LinearModel& core, const WheelFit& left, const WheelFit& right,
                      std::string source) const;

  Mission mission_;
  RobotLimits limits_;
  WheelPair metres_per_tick_;
  std::optional<EncoderScale> encoder_scale_;
  Activity last_activity_ = Activity::idle;
  std::optional<WheelTicks> check_start_;
  WheelTicks check_end_;
  std::vector<TurnSample> turn_samples_;
  std::vector<DriveLog> response_runs_;
  std::int64_t response_start_tick_ = 0;
  DriveLog random_run_;
  std::int64_t random_start_tick_ = 0;
  bool random_run_broke_ = false;  // counts got a new origin on the way
};

}  // namespace wheelwright

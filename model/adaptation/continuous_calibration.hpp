// The calibration that never ends (the source paper: "seamless during robot operation"): frames in, now and
// then a better model out, effects included.
//
//   watch   the hybrid filter says whether the model is still that of the robot,
//   adapt   once it is not: 15 s of sound driving make a candidate (model_adaptation.hpp),
//   judge   the next 16 s, which the candidate has not seen, are run freely by both models (model_trial.hpp).
//
// Only a candidate that is better there by more than a standard error is handed out; then it is the present
// one. Otherwise a new one is made from newer driving. While a wheel or an encoder has a fault nothing is
// learnt, and what was learnt since the model became due is thrown away, as the fault may have been in it
// before it was seen.
#pragma once

#include <optional>

#include "model/adaptation/model_adaptation.hpp"
#include "model/adaptation/model_trial.hpp"
#include "model/filter/hybrid_filter.hpp"
#include "model/log/sensor_frame.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

class ContinuousCalibration {
 public:
  enum class Phase : std::uint8_t { watch, adapt, judge };

  // Throws std::invalid_argument where the model has no encoder scale.
  explicit ContinuousCalibration(const RobotModel& model);

  // Each frame in order. Returns the model that is to be driven by from now on, where there is a better one.
  // Allocates where a phase begins.
  std::optional<RobotModel> take(const SensorFrame& frame);

  Phase phase() const { return phase_; }
  const RobotModel& model() const { return model_; }
  // The last trial, for what it says of both models.
  const std::optional<ModelTrial>& trial() const { return trial_; }

 private:
  void begin_adapting();
  std::optional<RobotModel> decide();

  RobotModel model_;
  HybridFilter filter_;
  Phase phase_ = Phase::watch;
  std::optional<ModelAdaptation> adaptation_;  // from the first frame on that is not spoilt by a fault
  std::optional<ModelTrial> trial_;
  RobotModel candidate_;
  double driven_s_ = 0.0;  // in this phase
};

}  // namespace wheelwright

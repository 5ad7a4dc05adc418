// Follows a slow change of the robot while it drives: how the present model would have to be corrected for
// its free run to agree with the encoders.
//
// For each wheel, with y the speed that the present model predicts from the commands alone,
//
//   corrected(k) = sum_j weight[j] y(k - 2 j),   j = 0, 1, 2
//
// which holds another gain, more delay and a slower answer, and leaves the type of the model and its poles as
// they are; before anything is learnt the weights are 1, 0, 0. The regressors are predictions, free of the
// encoders' noise, so that there is no bias by errors in variables, which an ARX fit on measured past speeds
// has (model/identification/arx_accumulator.hpp). Both sides are summed up to travel with a leak of one
// second: differences of counts are mostly noise, and sums without a leak carry an error on for ever.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "model/adaptation/directional_fit.hpp"
#include "model/log/sensor_frame.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

class ModelAdaptation {
 public:
  // Throws std::invalid_argument where the model has no encoder scale.
  explicit ModelAdaptation(const RobotModel& model);

  // Each frame in order. Of one that is not `sound` (a sensor fault, a robot that is not driven) only the
  // command is used, and nothing is learnt.
  void take(const SensorFrame& frame, bool sound);

  // The present model with the corrections so far.
  LinearModel adapted() const;

  const DirectionalFit& left() const { return wheels_[0].fit; }
  const DirectionalFit& right() const { return wheels_[1].fit; }

 private:
  static constexpr std::size_t lag_periods = 2;
  static constexpr std::size_t lags = 3;

  struct Wheel {
    DirectionalFit fit;
    double metres_per_tick;
    double reading_sd_m;
    std::array<double, lag_periods*(lags - 1) + 1> speeds_m_s{};          // predicted, newest first
    DirectionalFit::Vector predicted_m = DirectionalFit::Vector::Zero();  // travel with leak
    double counted_m = 0.0;
    std::int64_t ticks = 0;
  };

  void predict(Wheel& wheel, double speed_m_s) const;
  void learn(Wheel& wheel, std::int64_t ticks) const;
  void begin_sums(const SensorFrame& frame);
  static WheelResponse corrected(const WheelResponse& response, const DirectionalFit::Vector& weights);

  LinearModel model_;
  double kept_;  // of the sums over one period
  LinearPredictor predictor_;
  std::array<Wheel, 2> wheels_;
  WheelPair command_;
  std::int64_t tick_ = 0;
  bool started_ = false;
  bool summing_ = false;
  int quiet_ticks_ = 0;  // until counts whose signs were in doubt are behind
};

}  // namespace wheelwright

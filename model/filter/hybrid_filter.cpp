#include "model/filter/hybrid_filter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wheelwright {
namespace {

// After so many ticks without news the last command has long settled or was stopped.
constexpr std::int64_t most_ticks_left_out = 200;

WheelPair scale_of(const RobotModel& model) {
  if (!model.encoder_scale) {
    throw std::invalid_argument("the model has no encoder scale: calibrate it, or give metres per tick");
  }
  return model.encoder_scale->metres_per_tick;
}

WheelFilter wheel_filter(const FilterNoise& noise, double position_noise_m, double drift_m_per_sqrt_s,
                         double period_s) {
  WheelNoise wheel;
  wheel.refresh_period_s = noise.refresh_period_s;
  wheel.position_noise_m = position_noise_m;
  wheel.drift_m_per_sqrt_s = drift_m_per_sqrt_s;
  return WheelFilter(wheel, period_s);
}

}  // namespace

HybridFilter::HybridFilter(const RobotModel& model)
    : HybridFilter(model.core, scale_of(model), filter_noise_of(model)) {}

HybridFilter::HybridFilter(const LinearModel& model, const WheelPair& metres_per_tick,
                           const FilterNoise& noise)
    : period_s_(model.period_s),
      noise_(noise),
      predictor_(model),
      left_{wheel_filter(noise, noise.position_noise_m.left, noise.drift_m_per_sqrt_s.left, model.period_s),
            metres_per_tick.left, noise.gain_standard_error.left},
      right_{
          wheel_filter(noise, noise.position_noise_m.right, noise.drift_m_per_sqrt_s.right, model.period_s),
          metres_per_tick.right, noise.gain_standard_error.right},
      pose_(model.wheel_base_m, noise.scale_standard_error) {}

void HybridFilter::advance_model(const SensorFrame& frame) {
  predicted_m_ = {};
  const std::int64_t ticks =
      started_ ? std::clamp<std::int64_t>(frame.tick - tick_, 0, most_ticks_left_out) : 0;
  for (std::int64_t i = 0; i < ticks; ++i) {
    const WheelPair speed = predictor_.step(command_);
    predicted_m_.left += period_s_ * speed.left;
    predicted_m_.right += period_s_ * speed.right;
  }
  started_ = true;
  tick_ = frame.tick;
  command_ = frame.command.speed_m_s;
}

HybridWheel HybridFilter::step_wheel(Side& side, const SensorFrame& frame, double predicted_m,
                                     std::int64_t ticks, double& step_m, double& variance_m2) const {
  WheelReading reading;
  reading.predicted_m = predicted_m;
  reading.gain_standard_error = side.gain_standard_error;
  reading.doubtful = frame.doubtful_sign;
  reading.new_origin = frame.after_gap;
  reading.believed = !frame.armed;
  if (frame.valid) reading.counted_m = side.metres_per_tick * static_cast<double>(ticks);
  const WheelEstimate estimate = side.filter.step(reading);
  step_m = estimate.step_m;
  const double slip_m2 = noise_.slip_m_per_sqrt_m * noise_.slip_m_per_sqrt_m * std::abs(step_m);
  variance_m2 = slip_m2 + estimate.variance_growth_m2;
  HybridWheel wheel;
  wheel.speed_m_s = predicted_m / period_s_;
  wheel.innovation_m = estimate.innovation_m;
  if (estimate.heard) wheel.innovation = estimate.innovation_m / estimate.innovation_sd_m;
  wheel.accepted = estimate.accepted;
  wheel.discarded = estimate.heard && !estimate.accepted;
  return wheel;
}

HybridOutput HybridFilter::step(const SensorFrame& frame) {
  advance_model(frame);
  HybridOutput output;
  output.tick = frame.tick;
  WheelPair rolled_m;
  TravelVariance variance;
  output.left =
      step_wheel(left_, frame, predicted_m_.left, frame.ticks.left, rolled_m.left, variance.left_m2);
  output.right =
      step_wheel(right_, frame, predicted_m_.right, frame.ticks.right, rolled_m.right, variance.right_m2);
  pose_.move(rolled_m, variance);
  output.pose = pose_.pose();
  output.covariance = pose_.covariance();
  return output;
}

}  // namespace wheelwright

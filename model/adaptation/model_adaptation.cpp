#include "model/adaptation/model_adaptation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "model/filter/filter_noise.hpp"

namespace wheelwright {
namespace {

constexpr double leak_s = 1.0;
constexpr double memory_s = 20.0;  // of driving
constexpr double prior_standard_deviation = 0.1;
// Readings differ by the age of the counters too: more than the noise of a reading alone.
constexpr double min_reading_sd_m = 0.001;
constexpr int ticks_of_doubt = 10;
constexpr std::int64_t max_ticks_left_out = 200;
// A correction makes a response longer; one that follows on many others may not do so for ever.
constexpr std::size_t longest_response = 100;

WheelPair scale_of(const RobotModel& model) {
  if (!model.encoder_scale) {
    throw std::invalid_argument("the model has no encoder scale: calibrate it, or give metres per tick");
  }
  return model.encoder_scale->metres_per_tick;
}

}  // namespace

ModelAdaptation::ModelAdaptation(const RobotModel& model)
    : model_(model.linear_part),
      kept_(std::exp(-model.linear_part.period_s / leak_s)),
      predictor_(model.linear_part),
      wheels_{Wheel{DirectionalFit({1.0, 0.0, 0.0}, prior_standard_deviation,
                                   memory_s / model.linear_part.period_s),
                    scale_of(model).left,
                    std::max(min_reading_sd_m, filter_noise_of(model).position_noise_m.left)},
              Wheel{DirectionalFit({1.0, 0.0, 0.0}, prior_standard_deviation,
                                   memory_s / model.linear_part.period_s),
                    scale_of(model).right,
                    std::max(min_reading_sd_m, filter_noise_of(model).position_noise_m.right)}} {}

void ModelAdaptation::predict(Wheel& wheel, double speed_m_s) const {
  std::copy_backward(wheel.speeds_m_s.begin(), wheel.speeds_m_s.end() - 1, wheel.speeds_m_s.end());
  wheel.speeds_m_s.front() = speed_m_s;
  for (std::size_t j = 0; j < lags; ++j) {
    auto& travel_m = wheel.predicted_m[static_cast<Eigen::Index>(j)];
    travel_m = kept_ * travel_m + model_.period_s * wheel.speeds_m_s.at(lag_periods * j);
  }
}

void ModelAdaptation::learn(Wheel& wheel, std::int64_t ticks) const {
  wheel.counted_m =
      kept_ * wheel.counted_m + wheel.metres_per_tick * static_cast<double>(ticks - wheel.ticks);
  wheel.ticks = ticks;
  wheel.fit.take(wheel.predicted_m / wheel.reading_sd_m, wheel.counted_m / wheel.reading_sd_m);
}

void ModelAdaptation::begin_sums(const SensorFrame& frame) {
  wheels_[0].ticks = frame.ticks.left;
  wheels_[1].ticks = frame.ticks.right;
  for (Wheel& wheel : wheels_) {
    wheel.predicted_m.setZero();
    wheel.counted_m = 0.0;
  }
}

void ModelAdaptation::take(const SensorFrame& frame, bool sound) {
  const std::int64_t ticks =
      started_ ? std::clamp<std::int64_t>(frame.tick - tick_, 0, max_ticks_left_out) : 0;
  for (std::int64_t i = 0; i < ticks; ++i) {
    const WheelPair speed = predictor_.step(command_);
    predict(wheels_[0], speed.left);
    predict(wheels_[1], speed.right);
  }
  started_ = true;
  tick_ = frame.tick;
  command_ = frame.command.speed_m_s;
  if (frame.doubtful_sign) quiet_ticks_ = ticks_of_doubt;
  quiet_ticks_ = std::max(0, quiet_ticks_ - 1);
  const bool usable = sound && frame.valid && frame.armed && !frame.after_gap && quiet_ticks_ == 0;
  if (usable && summing_ && ticks == 1) {
    learn(wheels_[0], frame.ticks.left);
    learn(wheels_[1], frame.ticks.right);
  } else if (usable) {
    begin_sums(frame);
  }
  summing_ = usable;
}

WheelResponse ModelAdaptation::corrected(const WheelResponse& response,
                                         const DirectionalFit::Vector& weights) {
  const auto filtered = [&](const std::vector<double>& given) {
    std::vector<double> result(given.size() + lag_periods * (lags - 1), 0.0);
    for (std::size_t i = 0; i < given.size(); ++i) {
      for (std::size_t j = 0; j < lags; ++j) {
        result[i + lag_periods * j] += weights[static_cast<Eigen::Index>(j)] * given[i];
      }
    }
    // What is left out this far back is next to nothing; the gain has to stay.
    while (result.size() > std::max(longest_response, given.size())) {
      const double last = result.back();
      result.pop_back();
      result.back() += last;
    }
    return result;
  };
  return {filtered(response.from_left), filtered(response.from_right), response.from_own_past};
}

LinearModel ModelAdaptation::adapted() const {
  LinearModel model = model_;
  model.left = corrected(model_.left, wheels_[0].fit.weights());
  model.right = corrected(model_.right, wheels_[1].fit.weights());
  return model;
}

}  // namespace wheelwright

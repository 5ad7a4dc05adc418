#include "model/adaptation/model_adaptation.hpp"

#include <algorithm>
#include <cmath>

#include "model/adaptation/adaptation_fit.hpp"
#include "model/adaptation/free_run_start.hpp"
#include "model/filter/filter_noise.hpp"
#include "model/simulation/known_scale.hpp"
#include "model/simulation/model_simulation.hpp"

namespace wheelwright {
namespace {

constexpr double leak_s = 1.0;
constexpr double kept_driving_s = 120.0;
// Readings differ by the age of the counters too: more than the noise of a reading alone.
constexpr double min_reading_sd_m = 0.001;
constexpr int ticks_of_doubt = 10;
constexpr double longest_stand_s = 2.0;  // the rest of it says nothing

bool is_zero(const WheelPair& pair) {
  return pair.left == 0.0 && pair.right == 0.0;
}

}  // namespace

ModelAdaptation::ModelAdaptation(const RobotModel& model, const ModelSimulation& start)
    : model_(model),
      start_(start),
      max_periods_(static_cast<std::size_t>(kept_driving_s / model.linear_part.period_s)) {
  known_scale(model);
  periods_.reserve(max_periods_);
}

void ModelAdaptation::take(const SensorFrame& frame, bool sound) {
  const std::int64_t ticks =
      started_ ? std::clamp<std::int64_t>(frame.tick - tick_, 0, max_ticks_left_out) : 0;
  if (frame.doubtful_sign) quiet_ticks_ = ticks_of_doubt;
  quiet_ticks_ = std::max(0, quiet_ticks_ - 1);
  const bool usable = sound && frame.valid && frame.armed && !frame.after_gap && quiet_ticks_ == 0;
  if (frame.valid && frame.battery_v > 0.0) battery_v_ = frame.battery_v;
  remember(frame, ticks, usable);
  started_ = true;
  tick_ = frame.tick;
  command_ = frame.command.speed_m_s;
  was_usable_ = usable;
  if (usable) ticks_ = frame.ticks;
}

void ModelAdaptation::remember(const SensorFrame& frame, std::int64_t ticks, bool usable) {
  for (std::int64_t i = 0; i < ticks && periods_.size() < max_periods_; ++i) {
    Period period{command_, battery_v_, std::nullopt};
    if (usable && was_usable_ && ticks == 1) {
      const WheelPair scale = known_scale(model_);
      period.rolled_m = WheelPair{scale.left * static_cast<double>(frame.ticks.left - ticks_.left),
                                  scale.right * static_cast<double>(frame.ticks.right - ticks_.right)};
    }
    const bool stands = is_zero(command_) && (!period.rolled_m || is_zero(*period.rolled_m));
    standing_ticks_ = stands ? standing_ticks_ + 1 : 0;
    if (standing_ticks_ * model_.linear_part.period_s <= longest_stand_s) periods_.push_back(period);
  }
}

RobotModel ModelAdaptation::adapted() const {
  const AdaptedParameters parameters(model_);
  const double period_s = model_.linear_part.period_s;
  const double kept = std::exp(-period_s / leak_s);
  const auto settle_periods = static_cast<std::size_t>(settle_s / period_s);
  const FilterNoise noise = filter_noise_of(model_);
  // Sums with a leak tell one thing in each second.
  const double share = std::sqrt(period_s / leak_s);
  const WheelPair per_m{share / std::max(min_reading_sd_m, noise.position_noise_m.left),
                        share / std::max(min_reading_sd_m, noise.position_noise_m.right)};
  const auto residual_of = [&](const Eigen::VectorXd& at) {
    const RobotModel model = parameters.model_with(at);
    ModelSimulation simulation(model);
    simulation.take_over(start_);
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * periods_.size()));
    WheelPair off_m;  // predicted less counted, with leak
    for (std::size_t k = 0; k < periods_.size(); ++k) {
      const WheelPair& speed = simulation.step(periods_[k].command_m_s, periods_[k].battery_v).wheel_m_s;
      const auto& rolled_m = periods_[k].rolled_m;
      if (!rolled_m || k < settle_periods) {
        off_m = {};
        continue;
      }
      off_m.left = kept * off_m.left + period_s * speed.left - rolled_m->left;
      off_m.right = kept * off_m.right + period_s * speed.right - rolled_m->right;
      residual[static_cast<Eigen::Index>(2 * k)] = per_m.left * off_m.left;
      residual[static_cast<Eigen::Index>(2 * k + 1)] = per_m.right * off_m.right;
    }
    return residual;
  };
  return parameters.model_with(most_likely(parameters, residual_of));
}

}  // namespace wheelwright

#include "model/filter/gain_misfit.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright {
namespace {

constexpr double fit_block_s = 0.5;
// A wheel that rolls less within a block shows more of its noise than of its gain.
constexpr double min_way_m = 0.02;
constexpr double smallest_misfit = 0.04;
constexpr double certainty = 3.0;  // standard errors
constexpr double memory_blocks = 120.0;
constexpr std::size_t min_learnt = 10;  // blocks
// How far a window lies off by the speed that it was driven at, as a multiple of the spread of single blocks.
constexpr double share_of_spread = 1.2;

}  // namespace

GainMisfit::GainMisfit(double period_s)
    : ticks_per_block_(std::max(1, static_cast<int>(std::lround(fit_block_s / period_s)))) {}

void GainMisfit::drop_block() {
  ticks_ = 0;
  for (Wheel& wheel : wheels_) wheel.predicted_m = wheel.counted_m = 0.0;
}

void GainMisfit::restart() {
  drop_block();
  count_ = 0;
}

void GainMisfit::take(const WheelPair& predicted_m, const WheelPair& counted_m) {
  wheels_[0].predicted_m += predicted_m.left;
  wheels_[0].counted_m += counted_m.left;
  wheels_[1].predicted_m += predicted_m.right;
  wheels_[1].counted_m += counted_m.right;
  if (++ticks_ < ticks_per_block_) return;
  const bool driven =
      std::abs(wheels_[0].predicted_m) > min_way_m && std::abs(wheels_[1].predicted_m) > min_way_m;
  if (driven) {
    const bool leaves = count_ == blocks;
    learnt_ = std::min(learnt_ + (leaves ? 1 : 0), min_learnt);
    for (Wheel& wheel : wheels_) {
      if (leaves) learn(wheel, wheel.past_predicted_m.at(next_), wheel.past_counted_m.at(next_));
      wheel.past_predicted_m.at(next_) = wheel.predicted_m;
      wheel.past_counted_m.at(next_) = wheel.counted_m;
    }
    next_ = (next_ + 1) % blocks;
    count_ = std::min(count_ + 1, blocks);
  }
  drop_block();
}

GainMisfit::Error GainMisfit::error_of(const Wheel& wheel) {
  double power = 0.0;
  double product = 0.0;
  for (std::size_t i = 0; i < blocks; ++i) {
    power += wheel.past_predicted_m.at(i) * wheel.past_predicted_m.at(i);
    product += wheel.past_predicted_m.at(i) * wheel.past_counted_m.at(i);
  }
  const double gain = product / power;
  double scatter = 0.0;
  for (std::size_t i = 0; i < blocks; ++i) {
    const double residual_m = wheel.past_counted_m.at(i) - gain * wheel.past_predicted_m.at(i);
    scatter += residual_m * residual_m;
  }
  return {gain - 1.0, std::sqrt(scatter / (blocks - 1) / power)};
}

void GainMisfit::learn(Wheel& wheel, double predicted_m, double counted_m) {
  const double kept = 1.0 - 1.0 / memory_blocks;
  const double weight = predicted_m * predicted_m;
  const double error = counted_m / predicted_m - 1.0;
  wheel.weight = kept * wheel.weight + weight;
  wheel.error = kept * wheel.error + weight * error;
  wheel.square = kept * wheel.square + weight * error * error;
}

double GainMisfit::spread_of(const Wheel& wheel) const {
  if (learnt_ < min_learnt) return 0.0;
  const double mean = wheel.error / wheel.weight;
  return std::sqrt(std::max(0.0, wheel.square / wheel.weight - mean * mean));
}

bool GainMisfit::found() const {
  if (count_ < blocks) return false;
  return std::all_of(wheels_.begin(), wheels_.end(), [this](const Wheel& wheel) {
    const Error error = error_of(wheel);
    const double doubt = std::max(certainty * error.standard_error, share_of_spread * spread_of(wheel));
    return std::abs(error.value) > smallest_misfit + doubt;
  });
}

WheelPair GainMisfit::error() const {
  if (count_ < blocks) return {};
  return {error_of(wheels_[0]).value, error_of(wheels_[1]).value};
}

}  // namespace wheelwright

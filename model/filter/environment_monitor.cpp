#include "model/filter/environment_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wheelwright {
namespace {

constexpr double block_s = 0.25;
constexpr double settle_s = 1.0;
constexpr double driving_m_s = 0.03;
constexpr double excess_smoothing = 0.25;
// Before the need of current is known: what no sound driving takes, by the mean of a second or more.
constexpr int few_blocks = 4;
constexpr double most_times = 2.5;
constexpr double more_a = 0.1;
// CUSUM: shifts of twice the allowance are found fastest; a single block, however odd, is no proof.
constexpr double allowance = 0.75;
constexpr double max_of_one_block = 3.0;
constexpr double mean_size_of_normal = 0.8;  // standard deviation 1
constexpr double alarm = 10.0;
constexpr double innovation_alarm = 16.0;  // its blocks hang together more than those of current
// Of the alarm, that the sum of each wheel alone has to reach.
constexpr double share_of_each = 0.25;
constexpr double min_power = 0.5;  // less is no misfit, however unusual
constexpr double min_power_spread = 0.2;

double added_up(double sum, double score) {
  return std::max(0.0, sum + std::min(score, max_of_one_block) - allowance);
}

}  // namespace

EnvironmentMonitor::EnvironmentMonitor(double period_s)
    : ticks_per_block_(std::max(1, static_cast<int>(std::lround(block_s / period_s)))) {}

void EnvironmentMonitor::recalibrated() {
  wheels_ = {};
  both_ = {};
  due_ = false;
  ticks_ = 0;
}

void EnvironmentMonitor::drop_block() {
  ticks_ = 0;
  for (Wheel& wheel : wheels_) {
    wheel.features.setZero();
    wheel.current_a = wheel.innovation2 = 0.0;
  }
}

// A motor whose wheel is held draws several times as much as one that turns it.
double EnvironmentMonitor::excess_of(const Wheel& wheel, const CurrentModel::Features& features,
                                     double current_a) const {
  const double direction = features[0] < 0.0 ? -1.0 : 1.0;
  if (wheel.model.ready()) return direction * (current_a - wheel.model.expected_a(features));
  if (wheel.driving_ticks < few_blocks * ticks_per_block_) return 0.0;
  return std::max(0.0, direction * current_a - most_times * wheel.driving_a - more_a);
}

void EnvironmentMonitor::add_tick(Wheel& wheel, const CurrentModel::Features& features, double current_a,
                                  double innovation, double& excess_a) const {
  wheel.features += features;
  wheel.current_a += current_a;
  wheel.innovation2 += innovation * innovation;
  excess_a += excess_smoothing * (excess_of(wheel, features, current_a) - excess_a);
}

EnvironmentMonitor::BlockScore EnvironmentMonitor::close_block(Wheel& wheel) const {
  const double n = ticks_per_block_;
  const CurrentModel::Features features = wheel.features / n;
  const double current_a = wheel.current_a / n;
  const double power = std::log(wheel.innovation2 / n + min_power);
  const double direction = features[0] < 0.0 ? -1.0 : 1.0;
  BlockScore score;
  if (wheel.model.ready()) {
    score.current =
        direction * (current_a - wheel.model.expected_a(features)) / wheel.model.spread_a(features);
    score.other = std::abs(score.current) - mean_size_of_normal;
  }
  if (wheel.power.ready()) {
    const double spread = std::max(min_power_spread, wheel.power.spread());
    score.power = (power - wheel.power.mean()) / spread;
  }
  wheel.model.take(features, current_a);
  wheel.power.take(power);
  return score;
}

void EnvironmentMonitor::add_up(const BlockScore& left, const BlockScore& right) {
  const BlockScore both{(left.current + right.current) / std::numbers::sqrt2,
                        (left.other + right.other) / std::numbers::sqrt2, 0.0};
  const auto add = [](Sums& sums, const BlockScore& score) {
    sums.more = added_up(sums.more, score.current);
    sums.less = added_up(sums.less, -score.current);
    sums.other = added_up(sums.other, score.other);
    sums.rougher = added_up(sums.rougher, score.power);
  };
  add(wheels_[0].sums, left);
  add(wheels_[1].sums, right);
  add(both_, both);
}

double EnvironmentMonitor::score_of(double Sums::*sum) const {
  const double each = std::min(wheels_[0].sums.*sum, wheels_[1].sums.*sum);
  return std::min(both_.*sum / alarm, each / (share_of_each * alarm));
}

double EnvironmentMonitor::current_score() const {
  return std::max({score_of(&Sums::more), score_of(&Sums::less), score_of(&Sums::other)});
}

double EnvironmentMonitor::innovation_score() const {
  return std::min(wheels_[0].sums.rougher, wheels_[1].sums.rougher) / innovation_alarm;
}

bool EnvironmentMonitor::currents_are_known(const DrivingEvidence& evidence) {
  const auto& [left_speed, right_speed] = evidence.speed_m_s;
  current_sign_.take(left_speed, evidence.current_a.left);
  current_sign_.take(right_speed, evidence.current_a.right);
  return current_sign_.tells(left_speed, evidence.current_a.left) &&
         current_sign_.tells(right_speed, evidence.current_a.right);
}

bool EnvironmentMonitor::take(const DrivingEvidence& evidence) {
  const bool was_due = due_;
  due_ = due_ || evidence.both_misfit;
  if (!evidence.sound) {
    settle_ticks_ = static_cast<int>(std::lround(settle_s / block_s)) * ticks_per_block_;
    drop_block();
  } else if (settle_ticks_ > 0) {
    --settle_ticks_;
  }
  const auto& [left_speed, right_speed] = evidence.speed_m_s;
  const bool drives = std::abs(left_speed) > driving_m_s && std::abs(right_speed) > driving_m_s;
  if (!evidence.received || !drives) return due_ && !was_due;
  if (!currents_are_known(evidence)) {
    drop_block();
    return due_ && !was_due;
  }
  // The excess is wanted most while a wheel has a fault; learning waits until it is over.
  const bool counts = evidence.sound && settle_ticks_ == 0;
  const auto features = [&](double speed, double acceleration, double other_speed) {
    return CurrentModel::features(speed, acceleration, speed - other_speed, evidence.heading_rad);
  };
  add_tick(wheels_[0], features(left_speed, evidence.acceleration_m_s2.left, right_speed),
           current_sign_.along_wheel_a(left_speed, evidence.current_a.left), evidence.innovation.left,
           excess_a_.left);
  add_tick(wheels_[1], features(right_speed, evidence.acceleration_m_s2.right, left_speed),
           current_sign_.along_wheel_a(right_speed, evidence.current_a.right), evidence.innovation.right,
           excess_a_.right);
  if (!counts) {
    drop_block();
    return due_ && !was_due;
  }
  const auto note_driving = [](Wheel& wheel, double current_a) {
    ++wheel.driving_ticks;
    wheel.driving_a += (std::abs(current_a) - wheel.driving_a) / wheel.driving_ticks;
  };
  note_driving(wheels_[0], evidence.current_a.left);
  note_driving(wheels_[1], evidence.current_a.right);
  if (++ticks_ == ticks_per_block_) {
    const BlockScore left = close_block(wheels_[0]);
    add_up(left, close_block(wheels_[1]));
    drop_block();
    due_ = due_ || current_score() >= 1.0 || innovation_score() >= 1.0;
  }
  return due_ && !was_due;
}

}  // namespace wheelwright

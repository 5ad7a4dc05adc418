#include "model/filter/scale_drift_detector.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright {
namespace {

constexpr double mark_interval_s = 0.25;
// The gain drifts a little with speed, load and temperature, so it is never known better than this.
constexpr double gain_floor = 0.001;
constexpr double gain_walk_per_mark = 2e-5;
// Over less the windows say nothing of a scale.
constexpr double shortest_window_m = 0.4;
// Roughness is judged over 2 s, longer than the robot keeps one speed.
constexpr std::size_t roughness_marks = 8;
constexpr double slowest_roughness_rate = 0.01;
// Of the offset as filtered, between two marks.
constexpr double smallest_step_m = 0.0005;
// Standard deviations that the step between two marks counts for at most.
constexpr double largest_step = 2.0;

}  // namespace

ScaleDriftDetector::ScaleDriftDetector(double period_s, double gain_standard_error)
    : ticks_per_mark_(std::max(1, static_cast<int>(std::lround(mark_interval_s / period_s)))),
      gain_variance_(gain_standard_error * gain_standard_error) {}

double ScaleDriftDetector::gain_standard_error() const {
  return std::sqrt(gain_variance_ + gain_floor * gain_floor);
}

double ScaleDriftDetector::roughness() const {
  return std::sqrt(std::max(1.0, roughness2_));
}

void ScaleDriftDetector::interrupt() {
  ticks_ = 0;
  count_ = 0;
  statistic_ = whole_statistic_ = 0.0;
  collected_m_ = 0.0;
}

void ScaleDriftDetector::take(double predicted_m, double doubt_m, double offset_m, double process_variance_m2,
                              double reading_sd_m) {
  now_.model_m += predicted_m;
  now_.distance_m += std::abs(predicted_m);
  now_.doubt_m += doubt_m;
  now_.variance_m2 += process_variance_m2;
  now_.offset_m = offset_m;
  now_.reading_m2 = reading_sd_m * reading_sd_m;
  if (++ticks_ < ticks_per_mark_) return;
  ticks_ = 0;
  if (count_ == marks) {
    learn(past_[(newest_ + 1) % marks], past_[(newest_ + 2) % marks]);
    learn_roughness();
  } else {
    ++count_;
  }
  newest_ = (newest_ + 1) % marks;
  past_[newest_] = now_;
  look_back();
}

// Anything from none of it to all of it, all along the same.
double ScaleDriftDetector::doubt_variance_m2(const Mark& then, const Mark& now) {
  const double doubt_m = now.doubt_m - then.doubt_m;
  return doubt_m * doubt_m / 3.0;
}

double ScaleDriftDetector::step_variance_m2(const Mark& then, const Mark& now) const {
  return std::max(1.0, roughness2_) * (now.variance_m2 - then.variance_m2) + doubt_variance_m2(then, now) +
         smallest_step_m * smallest_step_m;
}

double ScaleDriftDetector::collected_m(const Mark& then, const Mark& now) const {
  return now.offset_m - then.offset_m - gain_error_ * (now.model_m - then.model_m);
}

void ScaleDriftDetector::look_back() {
  statistic_ = whole_statistic_ = 0.0;
  collected_m_ = 0.0;
  if (!ready()) return;
  const double gain_se = gain_standard_error();
  double steady_m = 0.0;
  Mark later = now_;
  for (std::size_t age = 1; age < count_; ++age) {
    const Mark& then = past_[(newest_ + marks - age) % marks];
    const double step_sd_m = std::sqrt(step_variance_m2(then, later));
    steady_m += std::clamp(collected_m(then, later), -largest_step * step_sd_m, largest_step * step_sd_m);
    later = then;
    const double distance_m = now_.distance_m - then.distance_m;
    if (distance_m < shortest_window_m) continue;
    const double random_m2 = now_.reading_m2 + then.reading_m2 + now_.variance_m2 - then.variance_m2;
    const double variance_m2 = std::max(1.0, roughness2_) * random_m2 +
                               gain_se * gain_se * distance_m * distance_m + doubt_variance_m2(then, now_);
    const double sd_m = std::sqrt(variance_m2);
    const double whole = collected_m(then, now_) / sd_m;
    if (std::abs(whole) > std::abs(whole_statistic_)) whole_statistic_ = whole;
    const double ratio = steady_m / sd_m;
    if (std::abs(ratio) > std::abs(statistic_)) {
      statistic_ = ratio;
      collected_m_ = collected_m(then, now_);
    }
  }
}

void ScaleDriftDetector::learn(const Mark& older, const Mark& newer) {
  gain_variance_ += gain_walk_per_mark * gain_walk_per_mark;
  const double model_m = newer.model_m - older.model_m;
  const double noise_m2 = step_variance_m2(older, newer);
  const double weight = gain_variance_ * model_m / (gain_variance_ * model_m * model_m + noise_m2);
  gain_error_ += weight * collected_m(older, newer);
  gain_variance_ *= 1.0 - weight * model_m;
}

void ScaleDriftDetector::learn_roughness() {
  const Mark& older = past_[(newest_ + 1) % marks];
  const Mark& newer = past_[(newest_ + 1 + roughness_marks) % marks];
  const double expected_m2 = newer.variance_m2 - older.variance_m2 + doubt_variance_m2(older, newer) +
                             smallest_step_m * smallest_step_m;
  const double step_m = collected_m(older, newer);
  ++learnt_;
  const double rate = std::max(slowest_roughness_rate, 1.0 / learnt_);
  roughness2_ += rate * (step_m * step_m / expected_m2 - roughness2_);
}

}  // namespace wheelwright

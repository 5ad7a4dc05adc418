#include "model/filter/fault_classifier.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright {
namespace {

// By definition: counts that are all missing for as long are frozen, for less they were dropped.
constexpr double frozen_s = 0.25;
constexpr double enough_to_call_dropped_s = 0.5;
constexpr double enough_to_call_dropped_m = 0.03;
constexpr double enough_to_call_still_m = 0.004;
// No wheel and no age of a reading makes a jump of so many standard deviations and more.
constexpr double jump_sd = 5.0;
// A motor that pulls at a wheel that stands draws this much more than one that turns it.
constexpr double stall_excess_a = 0.22;
constexpr int new_origin_matters_ticks = 40;

}  // namespace

void FaultClassifier::watch(const WheelEvidence& evidence) {
  std::shift_right(before_.begin(), before_.end(), 1);
  before_[0] = {evidence.predicted_m, evidence.counted_m, evidence.metres_per_tick};
  ticks_since_new_origin_ = evidence.new_origin ? 0 : std::min(ticks_since_new_origin_ + 1, 1 << 20);
}

void FaultClassifier::open() {
  ticks_ = 0;
  predicted_m_ = counted_m_ = distance_m_ = 0.0;
  jump_m_ = jump_counted_m_ = jump_predicted_m_ = 0.0;
  still_ticks_ = longest_still_ticks_ = 0;
  still_m_ = 0.0;
  after_new_origin_ = ticks_since_new_origin_ < new_origin_matters_ticks;
  for (std::size_t i = hindsight; i > 0; --i) add(before_[i - 1]);
}

void FaultClassifier::take(const WheelEvidence& evidence) {
  ++ticks_;
  if (evidence.new_origin) after_new_origin_ = true;
  reading_sd_m_ = evidence.reading_sd_m;
  excess_a_ = evidence.excess_a;
  if (evidence.received) add({evidence.predicted_m, evidence.counted_m, evidence.metres_per_tick});
}

void FaultClassifier::add(const Step& step) {
  predicted_m_ += step.predicted_m;
  counted_m_ += step.counted_m;
  distance_m_ += std::abs(step.predicted_m);
  const double jump_m = step.counted_m - step.predicted_m;
  if (std::abs(jump_m) > std::abs(jump_m_)) {
    jump_m_ = jump_m;
    jump_counted_m_ = step.counted_m;
    jump_predicted_m_ = step.predicted_m;
  }
  if (std::abs(step.counted_m) >= 0.5 * step.metres_per_tick) {
    still_ticks_ = 0;
    still_m_ = 0.0;
  } else if (std::abs(step.predicted_m) > 0.5 * step.metres_per_tick) {
    ++still_ticks_;
    still_m_ += std::abs(step.predicted_m);
  }
  longest_still_ticks_ = std::max(longest_still_ticks_, still_ticks_);
}

// A counter that merely misses what the wheel did never goes back, and never ahead of it.
bool FaultClassifier::jumped() const {
  const bool large = std::abs(jump_m_) > std::max(min_jump_m, jump_sd * reading_sd_m_);
  const bool only_missing =
      jump_counted_m_ * jump_predicted_m_ >= 0.0 && std::abs(jump_counted_m_) <= std::abs(jump_predicted_m_);
  return large && !only_missing;
}

bool FaultClassifier::is_stall() const {
  return still_ticks_ >= 3 && still_m_ >= enough_to_call_still_m && excess_a_ > stall_excess_a;
}

FaultKind FaultClassifier::name_by_now() const {
  const bool still = still_ticks_ * period_s_ >= frozen_s && still_m_ >= 2.0 * enough_to_call_still_m;
  if (still) return jumped() || after_new_origin_ ? FaultKind::stuck_at : FaultKind::frozen;
  const bool long_enough =
      ticks_ * period_s_ >= enough_to_call_dropped_s && distance_m_ >= enough_to_call_dropped_m;
  const double share = counted_m_ / predicted_m_;
  if (long_enough && !jumped() && still_ticks_ * period_s_ < 0.1 && share > 0.02 && share < 0.95) {
    return FaultKind::dropped;
  }
  return FaultKind::misfit;
}

FaultKind FaultClassifier::name_at_end(double kept_out_m) const {
  const FaultKind known = name_by_now();
  if (known != FaultKind::misfit) return known;
  if (longest_still_ticks_ * period_s_ >= frozen_s) return jumped() ? FaultKind::stuck_at : FaultKind::frozen;
  if (jumped()) return FaultKind::spike;
  const double missing_m = -kept_out_m * (predicted_m_ < 0.0 ? -1.0 : 1.0);
  return missing_m >= 0.0 ? FaultKind::dropped : FaultKind::misfit;
}

}  // namespace wheelwright

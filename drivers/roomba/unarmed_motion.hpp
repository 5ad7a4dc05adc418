// Whether wheels turn that nobody ordered to turn: a robot that cleans by itself, is pushed, or obeys another
// program.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wheelwright::roomba {

class UnarmedMotion {
 public:
  explicit UnarmedMotion(double period_s)
      : braking_samples_(static_cast<int>(std::ceil(braking_s / period_s))),
        still_samples_(static_cast<int>(std::ceil(still_s / period_s))) {}

  // Takes the ticks of the wheel that turned more since the last sample. Returns true once for each time that
  // the wheels begin to turn.
  bool take(bool armed, std::int64_t ticks) {
    unarmed_samples_ = armed ? 0 : std::min(unarmed_samples_ + 1, braking_samples_);
    if (unarmed_samples_ < braking_samples_) {
      travel_ = 0;
      return false;
    }
    still_for_ = ticks == 0 ? still_for_ + 1 : 0;
    if (still_for_ >= still_samples_) {
      travel_ = 0;
      moves_ = false;
    }
    travel_ += ticks;
    if (moves_ || travel_ < enough_ticks) return false;
    moves_ = true;
    return true;
  }

 private:
  static constexpr double braking_s = 3.0;  // the slowest of old motors still creep for a second
  static constexpr double still_s = 1.0;
  static constexpr std::int64_t enough_ticks = 40;  // 18 mm: not the jolt of somebody who touches the robot

  int braking_samples_;
  int still_samples_;
  int unarmed_samples_ = 0;
  int still_for_ = 0;
  std::int64_t travel_ = 0;
  bool moves_ = false;
};

}  // namespace wheelwright::roomba

// The time that a sensor stream counts: a robot sends a frame each period, also one that arrives damaged.
#pragma once

#include <cstdint>
#include <optional>

namespace wheelwright::roomba {

class StreamClock {
 public:
  // A sound frame has come, `damaged` others since the one before it. Returns how many periods have to be
  // made up for: those of the damaged frames, less those in which silence was noticed.
  std::int64_t frame(double now_s, std::int64_t damaged) {
    if (frames_ == 0) {
      first_frame_s_ = now_s;
      damaged = 0;
    }
    frames_ += 1 + damaged;
    if (!period_s_ && frames_ > frames_to_measure)
      period_s_ = (now_s - first_frame_s_) / static_cast<double>(frames_ - 1);
    const std::int64_t missing = damaged > silent_periods_ ? damaged - silent_periods_ : 0;
    silent_periods_ = 0;
    return missing;
  }
  // A period has gone by without a frame.
  void silence() { ++silent_periods_; }
  // As the first 200 frames show it; nothing before.
  std::optional<double> period_s() const { return period_s_; }

 private:
  static constexpr std::int64_t frames_to_measure = 200;

  std::int64_t frames_ = 0;
  double first_frame_s_ = 0.0;
  std::int64_t silent_periods_ = 0;
  std::optional<double> period_s_;
};

// So far off that a model would have wrong gains: the robot streams at another period than is configured.
constexpr bool is_another_period(double measured_s, double configured_s) {
  constexpr double most = 0.05;
  return measured_s > (1.0 + most) * configured_s || measured_s < (1.0 - most) * configured_s;
}

}  // namespace wheelwright::roomba

// What the calibrator makes of response actions.
#include "model/brain/calibrator.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double metres_per_tick = 0.000444565;

// Wheels that follow their commands with a lag of 60 ms and gain 0.95; the right one may crawl on after it
// was told to stop, a tick per period, for so many periods. So many readings hold counts that no wheel can
// have made.
class LaggingWheels {
 public:
  explicit LaggingWheels(int crawl_periods, int refused_readings = 0)
      : calibrator_(mission(), RobotLimits{}, {}),
        crawl_(crawl_periods),
        refused_readings_(refused_readings) {}

  CalibrationOutcome respond() {
    for (std::uint16_t repetition = 0; repetition < 4; ++repetition) {
      const double speed_m_s = 0.14 + 0.01 * repetition;
      hold({speed_m_s, 0.0}, Activity::left_on, repetition, 55, 0);
      hold({}, Activity::left_off, repetition, 90, 0);
      hold({0.0, speed_m_s}, Activity::right_on, repetition, 55, 0);
      hold({}, Activity::right_off, repetition, 90, crawl_);
    }
    return *hold({}, Activity::await_response, 0, 1, 0);
  }

 private:
  static Mission mission() {
    Mission mission;
    mission.response = ResponsePlan{};
    return mission;
  }

  std::optional<CalibrationOutcome> hold(const WheelPair& command, Activity activity,
                                         std::uint16_t repetition, int periods, int crawl_periods) {
    std::optional<CalibrationOutcome> outcome;
    for (int k = 0; k < periods; ++k) {
      SensorFrame frame;
      frame.tick = tick_++;
      frame.valid = frame.armed = true;
      frame.battery_v = 15.0;
      if (activity == Activity::left_on && k % 7 == 3 && refused_readings_-- > 0) frame.valid = false;
      frame.command = {frame.tick, command, activity, repetition};
      frame.ticks = {std::llround(travel_m_.left / metres_per_tick),
                     std::llround(travel_m_.right / metres_per_tick)};
      frame.counted_ticks = frame.ticks;
      if (auto found = calibrator_.take(frame)) outcome = std::move(found);
      const double kept = std::exp(-period_s / 0.06);
      speed_m_s_.left = kept * speed_m_s_.left + (1.0 - kept) * 0.95 * command.left;
      speed_m_s_.right = kept * speed_m_s_.right + (1.0 - kept) * 0.95 * command.right;
      travel_m_.left += period_s * speed_m_s_.left;
      travel_m_.right += period_s * speed_m_s_.right + (k < crawl_periods ? metres_per_tick : 0.0);
    }
    return outcome;
  }

  Calibrator calibrator_;
  int crawl_;
  int refused_readings_;
  std::int64_t tick_ = 0;
  WheelPair speed_m_s_;
  WheelPair travel_m_;
};

}  // namespace

TEST_CASE("A wheel that crawls on long after it was told to stop does not get the way crawled as gain") {
  for (const int crawl_periods : {0, 60}) {
    INFO(crawl_periods << " periods");
    const auto outcome = LaggingWheels(crawl_periods).respond();
    REQUIRE(outcome.response);
    CHECK_THAT(outcome.response->right.gain.from_right, WithinAbs(0.95, 0.01));
    CHECK_THAT(outcome.response->left.gain.from_left, WithinAbs(0.95, 0.01));
  }
}

TEST_CASE("A calibration stands a handful of readings with counts that no wheel can have made, and no more") {
  CHECK(LaggingWheels(0, 5).respond().response);
  const auto outcome = LaggingWheels(0, 6).respond();
  REQUIRE(outcome.refusal);
  CHECK_THAT(outcome.refusal->reason, ContainsSubstring("6 readings hold encoder counts"));
  CHECK_THAT(outcome.refusal->reason, ContainsSubstring("wheelwright doctor"));
}

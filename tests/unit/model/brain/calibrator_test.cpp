// What the calibrator makes of response actions.
#include "model/brain/calibrator.hpp"

#include <cmath>
#include <functional>
#include <utility>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double metres_per_tick = 0.000444565;

// Of a reading, by what the robot does, how many periods ago that began, and tick.
using Lateness = std::function<std::int32_t(Activity activity, int since_change, std::int64_t tick)>;

// Wheels that follow their commands with a lag of 60 ms and gain 0.95; the right one may crawl on after it
// was told to stop, a tick per period, for so many periods. So many readings hold counts that no wheel can
// have made.
class LaggingWheels {
 public:
  explicit LaggingWheels(int crawl_periods, int refused_readings = 0, Lateness late_us = {})
      : calibrator_(mission(), RobotLimits{}, {}),
        crawl_(crawl_periods),
        refused_readings_(refused_readings),
        late_us_(std::move(late_us)) {}

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
      if (late_us_) frame.late_us = late_us_(activity, k, frame.tick);
      // What is read late is what was counted by then.
      const double late_s = 1e-6 * frame.late_us;
      frame.ticks = {std::llround((travel_m_.left + late_s * speed_m_s_.left) / metres_per_tick),
                     std::llround((travel_m_.right + late_s * speed_m_s_.right) / metres_per_tick)};
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
  Lateness late_us_;
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

TEST_CASE(
    "Readings that come more than half a period late are left out of a response, and it says how many") {
  const auto prompt = LaggingWheels(0).respond();
  const auto late = LaggingWheels(0, 0, [](Activity, int since_change, std::int64_t tick) {
                      return since_change > 0 && tick % 40 == 7 ? 17'000 : 0;
                    }).respond();
  REQUIRE(prompt.response);
  REQUIRE(late.response);
  CHECK_FALSE(prompt.remark);
  REQUIRE(late.remark);
  CHECK_THAT(*late.remark,
             ContainsSubstring("readings came more than half a period late, the latest by 17 ms"));
  CHECK(late.response->rows < prompt.response->rows);
  CHECK_THAT(late.response->left.gain.from_left, WithinAbs(prompt.response->left.gain.from_left, 0.002));
}

TEST_CASE("A response on a machine that was often late is refused, with how late and what to do") {
  const auto outcome = LaggingWheels(0, 0, [](Activity, int, std::int64_t tick) {
                         return tick % 15 == 7 ? 41'000 : 0;
                       }).respond();
  REQUIRE(outcome.refusal);
  CHECK_THAT(outcome.refusal->reason, ContainsSubstring("the machine was too busy"));
  CHECK_THAT(outcome.refusal->reason, ContainsSubstring("the latest by 41 ms; end other programs"));
}

TEST_CASE(
    "Commands that begin late and end in time widen the gain's interval by their share of the time in "
    "force") {
  const auto standard_error = [](std::int32_t on_us, std::int32_t off_us) {
    const auto lateness = [=](Activity activity, int since_change, std::int64_t) {
      if (since_change > 0) return 0;
      return activity == Activity::left_on || activity == Activity::right_on ? on_us : off_us;
    };
    return LaggingWheels(0, 0, lateness).respond().response->left.gain_standard_error.from_left;
  };
  const double punctual = standard_error(0, 0);
  const double of_one_action = 0.008 / (55 * period_s);
  CHECK_THAT(standard_error(8'000, 0),
             WithinRel(std::hypot(punctual, 0.95 * of_one_action / std::sqrt(4.0)), 0.05));
  CHECK(standard_error(8'000, 8'000) < 0.6 * standard_error(8'000, 0));
}

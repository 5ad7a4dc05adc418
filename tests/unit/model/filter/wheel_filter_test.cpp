// One wheel against a model that is right, with readings made by hand.
#include <cmath>
#include <limits>

#include "model/filter/wheel_filter.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double step_m = 0.2 * period_s;

// A wheel at 0.2 m/s whose encoder shows the travel plus `offset_m`.
struct Drive {
  WheelFilter filter{WheelNoise{}, period_s};
  double travel_m = 0.0;
  double estimate_m = 0.0;
  bool doubtful = false;

  WheelEstimate tick(double offset_m, bool received = true) {
    travel_m += step_m;
    WheelReading reading;
    reading.predicted_m = step_m;
    reading.gain_standard_error = 0.002;
    reading.doubtful = doubtful;
    if (received) reading.counted_m = travel_m + offset_m;
    const WheelEstimate estimate = filter.step(reading);
    estimate_m += estimate.step_m;
    return estimate;
  }
  double error_m() const { return estimate_m - travel_m; }
};

}  // namespace

TEST_CASE("A counter that jumps is discarded, and its offset stays out for good") {
  Drive drive;
  for (int k = 0; k < 50; ++k) CHECK(drive.tick(0.0).accepted);
  CHECK_FALSE(drive.tick(0.05).accepted);
  double kept_out_m = 0.0;
  int proof = 0;
  for (int k = 0; k < 50; ++k) {
    const WheelEstimate estimate = drive.tick(0.05);
    if (estimate.resynchronised) kept_out_m = estimate.kept_out_m;
    if (estimate.suspended) ++proof;
  }
  CHECK_THAT(kept_out_m, WithinAbs(0.05, 0.002));
  CHECK(proof < 12);
  CHECK(drive.tick(0.05).accepted);
  CHECK_THAT(drive.error_m(), WithinAbs(0.0, 0.002));
}

TEST_CASE("While an encoder is frozen the model stands in, and the missing travel is not lost") {
  Drive drive;
  for (int k = 0; k < 50; ++k) drive.tick(0.0);
  double missing_m = 0.0;
  for (int k = 0; k < 100; ++k) drive.tick(missing_m -= step_m);
  for (int k = 0; k < 30; ++k) drive.tick(missing_m);
  CHECK(drive.tick(missing_m).accepted);
  CHECK_THAT(drive.error_m(), WithinAbs(0.0, 0.003));
}

TEST_CASE("A jump that is no larger than the ages of readings are is found by the mean of a few") {
  Drive drive;
  // What a poll every 18 ms sees of a counter that is refreshed every 15.6 ms.
  double age_s = 0.0;
  const auto with_age = [&](double offset_m) {
    age_s = std::fmod(age_s + period_s, 1.0 / 64.0);
    return drive.tick(offset_m - 0.2 * age_s);
  };
  for (int k = 0; k < 200; ++k) REQUIRE(with_age(0.0).accepted);
  int used = 0;
  while (used < 50 && with_age(0.004).accepted) ++used;
  CHECK(used <= 8);
  double kept_out_m = 0.0;
  for (int k = 0; k < 50; ++k) kept_out_m += with_age(0.004).kept_out_m;
  CHECK_THAT(kept_out_m, WithinAbs(0.004, 0.001));
}

TEST_CASE("Doubt about the sign of counts excuses no counter that stands still") {
  Drive drive;
  for (int k = 0; k < 50; ++k) drive.tick(0.0);
  drive.doubtful = true;
  double missing_m = 0.0;
  int used = 0;
  while (used < 50 && drive.tick(missing_m -= step_m).accepted) ++used;
  CHECK(used <= 2);
}

TEST_CASE("Doubt about the sign of counts excuses no jump farther than the wheel can have turned") {
  Drive drive;
  for (int k = 0; k < 50; ++k) drive.tick(0.0);
  drive.doubtful = true;
  CHECK(drive.tick(-2.0 * step_m).accepted);  // counted backwards
  drive.doubtful = false;
  for (int k = 0; k < 50; ++k) CHECK(drive.tick(-2.0 * step_m).accepted);
  drive.doubtful = true;
  CHECK_FALSE(drive.tick(0.015).accepted);
}

TEST_CASE("A reading that comes back to where it was is taken without a new origin") {
  Drive drive;
  for (int k = 0; k < 50; ++k) drive.tick(0.0);
  drive.tick(-0.2);
  bool resynchronised = false;
  for (int k = 0; k < 20; ++k) {
    const WheelEstimate estimate = drive.tick(0.0);
    if (!estimate.resynchronised) continue;
    resynchronised = true;
    CHECK(estimate.kept_out_m == 0.0);
  }
  CHECK(resynchronised);
}

TEST_CASE("Sensors that are not heard cost certainty, not readings") {
  Drive drive;
  for (int k = 0; k < 50; ++k) drive.tick(0.0);
  const double before_m2 = drive.filter.variance_m2();
  for (int k = 0; k < 20; ++k) drive.tick(0.0, false);
  CHECK(drive.filter.variance_m2() > before_m2);
  CHECK(drive.tick(0.0).accepted);
}

TEST_CASE("A wheel that stands proves nothing of its encoder") {
  WheelFilter filter(WheelNoise{}, period_s);
  const auto stand = [&](double counted_m) {
    WheelReading reading;
    reading.counted_m = counted_m;
    return filter.step(reading);
  };
  for (int k = 0; k < 20; ++k) stand(0.0);
  CHECK_FALSE(stand(0.1).accepted);
  for (int k = 0; k < 500; ++k) CHECK(stand(0.1).suspended);
}

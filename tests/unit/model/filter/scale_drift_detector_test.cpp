// What is a drift of an encoder's scale, and what is not.
#include <cmath>
#include <random>

#include "model/filter/scale_drift_detector.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double speed_m_s = 0.2;
constexpr double drift_m_per_sqrt_s = 0.0003;
constexpr double reading_sd_m = 0.0007;
constexpr double gate = 7.0;  // as in fault_detector.cpp

// A wheel at constant speed, whose offset against the model walks as the noise figures say.
class Wheel {
 public:
  explicit Wheel(std::uint64_t seed) : random_(seed) {}

  // Drives on, while the counts gain `beyond_m_s` on the model, which may be another by `doubt_m_s`. Returns
  // the largest statistic.
  double drive(double duration_s, double beyond_m_s = 0.0, double doubt_m_s = 0.0) {
    double largest = 0.0;
    for (double t_s = 0.0; t_s < duration_s; t_s += period_s) {
      offset_m_ += beyond_m_s * period_s + drift_m_per_sqrt_s * std::sqrt(period_s) * normal_(random_);
      test_.take(speed_m_s * period_s, doubt_m_s * period_s, offset_m_,
                 drift_m_per_sqrt_s * drift_m_per_sqrt_s * period_s, reading_sd_m);
      largest = std::max(largest, std::abs(test_.statistic()));
    }
    return largest;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  ScaleDriftDetector test_{period_s, 0.005};
  double offset_m_ = 0.0;
};

}  // namespace

TEST_CASE("A scale that is off by 2 per cent from one moment on is a drift within 16 s") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Wheel wheel(seed);
    CAPTURE(seed);
    CHECK(wheel.drive(40.0) < gate);
    CHECK(wheel.drive(16.0, 0.02 * speed_m_s) > gate);
  }
}

TEST_CASE("A wheel that a model has wrong for a second by 15 mm does not drift") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Wheel wheel(seed);
    CAPTURE(seed);
    double largest = wheel.drive(40.0);
    for (int k = 0; k < 5; ++k) {
      largest = std::max(largest, wheel.drive(1.0, k % 2 == 0 ? 0.015 : -0.015));
      largest = std::max(largest, wheel.drive(20.0));
    }
    CHECK(largest < gate);
  }
}

TEST_CASE("Travel that the model is in doubt of is no drift") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Wheel wheel(seed);
    CAPTURE(seed);
    CHECK(wheel.drive(40.0) < gate);
    CHECK(wheel.drive(10.0, 0.0285, 0.0285) < gate);
  }
}

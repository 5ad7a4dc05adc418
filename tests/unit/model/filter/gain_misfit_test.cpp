// Another gain than the model's, told from noise and from a fault of one wheel.
#include "model/filter/gain_misfit.hpp"

#include <cmath>
#include <optional>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double counting_noise_m = 0.0008;

// Driving at 0.15 m/s by the model, wheels that roll `factor` as far, and readings with noise of their own.
// Returns the time until the misfit is found.
std::optional<double> found_after_s(GainMisfit& misfit, const WheelPair& factor, unsigned seed,
                                    double duration_s) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, counting_noise_m);
  WheelPair last;
  for (int k = 0; k * period_s < duration_s; ++k) {
    const WheelPair now{noise(random), noise(random)};
    const double step_m = 0.15 * period_s;
    misfit.take({step_m, step_m}, {factor.left * step_m + now.left - last.left,
                                   factor.right * step_m + now.right - last.right});
    last = now;
    if (misfit.found()) return k * period_s;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("A gain of both wheels that is off by 7 per cent is found within 6 s, to either side") {
  for (const double factor : {0.93, 1.07}) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
      GainMisfit misfit(period_s);
      const auto after_s = found_after_s(misfit, {factor, factor}, seed, 60.0);
      REQUIRE(after_s);
      CHECK(*after_s < 6.0);
      CHECK_THAT(misfit.error().left, WithinAbs(factor - 1.0, 0.015));
    }
  }
}

TEST_CASE("A gain that is off by 2 per cent, or on one wheel only, is no misfit of the model") {
  for (const WheelPair factor : {WheelPair{1.02, 1.02}, WheelPair{0.98, 0.98}, WheelPair{1.1, 1.0}}) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
      GainMisfit misfit(period_s);
      CHECK_FALSE(found_after_s(misfit, factor, seed, 120.0));
    }
  }
}

TEST_CASE("A robot that stands, and one that turns on one wheel, show no gain") {
  GainMisfit misfit(period_s);
  for (int k = 0; k < 10000; ++k) {
    misfit.take({0.0, 0.0}, {0.0005, -0.0005});
    misfit.take({0.0, 0.002}, {0.0, 0.001});
  }
  CHECK_FALSE(misfit.found());
}

TEST_CASE("After a restart nothing is found until as much has been driven again") {
  GainMisfit misfit(period_s);
  REQUIRE(found_after_s(misfit, {1.1, 1.1}, 1, 20.0));
  misfit.restart();
  CHECK_FALSE(misfit.found());
  CHECK(*found_after_s(misfit, {1.1, 1.1}, 2, 20.0) > 4.0);
}

TEST_CASE("Where the gain depends on the speed, a while at one speed is no misfit") {
  GainMisfit misfit(period_s);
  const auto drive = [&](double speed_m_s, double duration_s) {
    // The robot acts in steps of 28 mm/s.
    const double step_m_s = 0.0285 * std::round(speed_m_s / 0.0285);
    for (int k = 0; k * period_s < duration_s; ++k) {
      misfit.take({speed_m_s * period_s, speed_m_s * period_s}, {step_m_s * period_s, step_m_s * period_s});
      if (misfit.found()) return true;
    }
    return false;
  };
  // The speeds of a minute's drive, in no order.
  for (int k = 0; k < 60; ++k) CHECK_FALSE(drive(0.08 + 0.17 * std::fmod(0.618034 * k, 1.0), 1.0));
  CHECK_FALSE(drive(0.155, 20.0));
}

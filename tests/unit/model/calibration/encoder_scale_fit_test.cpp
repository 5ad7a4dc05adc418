#include "model/calibration/encoder_scale_fit.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

struct Scene {
  double ticks_per_turn = 1660.0;
  double turns = 3.0;
  double noise = 5.0;
  std::vector<double> obstacle_bearings_rad = {0.4, 2.1, 3.9};
  double obstacle_width_rad = 0.25;
  unsigned seed = 1;
  double drift_rad_per_turn = 0.0;  // by which all bearings shift
  bool and_back = false;
};

// What six sensors across the front see of round bumps in the surroundings while the robot turns.
std::vector<TurnSample> turn_past(const Scene& scene) {
  std::mt19937 random(scene.seed);
  std::normal_distribution<double> normal(0.0, scene.noise);
  std::vector<TurnSample> samples;
  const double way_ticks = scene.turns * scene.ticks_per_turn;
  for (double gone = 0.0; gone < (scene.and_back ? 2.0 : 1.0) * way_ticks; gone += 4.1) {
    const double ticks = gone < way_ticks ? gone : 2.0 * way_ticks - gone;
    const double drifted_rad = scene.drift_rad_per_turn * gone / scene.ticks_per_turn;
    const double heading = 2.0 * std::numbers::pi * ticks / scene.ticks_per_turn - drifted_rad;
    TurnSample sample;
    sample.ticks = {-std::llround(ticks), std::llround(ticks)};
    for (std::size_t s = 0; s < sample.light_bumper.size(); ++s) {
      const double bearing = heading + 1.1 - 0.44 * static_cast<double>(s);
      double signal = 50.0 + normal(random);
      for (const double obstacle : scene.obstacle_bearings_rad) {
        const double off =
            std::remainder(bearing - obstacle, 2.0 * std::numbers::pi) / scene.obstacle_width_rad;
        signal += 900.0 * std::exp(-0.5 * off * off);
      }
      sample.light_bumper.at(s) = static_cast<std::uint16_t>(std::clamp(signal, 0.0, 4095.0));
    }
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace

TEST_CASE(
    "Ticks per turn are found whatever the surroundings, and metres per tick follow from the wheel base") {
  for (const double ticks : {1480.0, 1660.0, 1851.3}) {
    const auto fit = fit_encoder_scale(turn_past({.ticks_per_turn = ticks}), {});
    REQUIRE(fit);
    CHECK_THAT(fit->ticks_per_turn, WithinRel(ticks, 0.001));
    CHECK_THAT(fit->metres_per_tick.left, WithinRel(std::numbers::pi * 0.235 / ticks, 0.001));
  }
}

TEST_CASE("Both methods agree on a single obstacle") {
  const auto samples = turn_past({.turns = 4.0, .obstacle_bearings_rad = {1.0}});
  const auto by_correlation = fit_encoder_scale(samples, {});
  EncoderScaleOptions peaks;
  peaks.method = PeriodMethod::peak;
  const auto by_peaks = fit_encoder_scale(samples, peaks);
  REQUIRE(by_correlation);
  REQUIRE(by_peaks);
  CHECK_THAT(by_peaks->ticks_per_turn, WithinRel(1660.0, 0.002));
  CHECK_THAT(by_correlation->ticks_per_turn, WithinRel(by_peaks->ticks_per_turn, 0.002));
}

TEST_CASE("A room of four like walls is not taken for four turns in one") {
  const double quarter = 0.5 * std::numbers::pi;
  const auto fit = fit_encoder_scale(
      turn_past({.obstacle_bearings_rad = {0.0, quarter, 2.0 * quarter, 3.0 * quarter}}), {});
  REQUIRE(fit);
  CHECK_THAT(fit->ticks_per_turn, WithinRel(1660.0, 0.002));
}

TEST_CASE("The stated error covers the true one") {
  int covered = 0;
  constexpr int trials = 40;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const auto fit = fit_encoder_scale(turn_past({.noise = 60.0, .seed = seed}), {});
    REQUIRE(fit);
    const double error = std::abs(fit->ticks_per_turn / 1660.0 - 1.0);
    if (error <= 2.5 * fit->relative_standard_error) ++covered;
  }
  CHECK(covered >= 0.85 * trials);
}

TEST_CASE("A drift that shifts what the robot sees cancels when it turns back") {
  const Scene one_way{.drift_rad_per_turn = 0.06};
  const auto wrong = fit_encoder_scale(turn_past(one_way), {});
  REQUIRE(wrong);
  CHECK_THAT(wrong->ticks_per_turn / 1660.0, WithinAbs(1.0 + 0.06 / (2.0 * std::numbers::pi), 0.001));
  CHECK_FALSE(wrong->drift);

  const auto right =
      fit_encoder_scale(turn_past({.turns = 2.0, .drift_rad_per_turn = 0.06, .and_back = true}), {});
  REQUIRE(right);
  CHECK_THAT(right->ticks_per_turn, WithinRel(1660.0, 0.0005));
  CHECK_THAT(right->drift.value(), WithinAbs(0.06 / (2.0 * std::numbers::pi), 0.001));
  CHECK_THAT(right->turns, WithinAbs(4.0, 0.05));
}

TEST_CASE("A drift makes the stated error larger, for not all of it cancels") {
  const auto still = fit_encoder_scale(turn_past({.turns = 2.0, .and_back = true}), {});
  const auto drifting =
      fit_encoder_scale(turn_past({.turns = 2.0, .drift_rad_per_turn = 0.06, .and_back = true}), {});
  REQUIRE(still);
  REQUIRE(drifting);
  CHECK(drifting->relative_standard_error > 0.0005);
  CHECK(still->relative_standard_error < 0.0005);
}

TEST_CASE("An object that is out of sight on the way back is a reason to put more of them there") {
  auto samples = turn_past({.turns = 2.0, .and_back = true});
  const auto nothing = turn_past({.turns = 2.0, .obstacle_bearings_rad = {}, .and_back = true});
  std::copy(nothing.begin() + static_cast<std::ptrdiff_t>(nothing.size() / 2), nothing.end(),
            samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2));
  const auto fit = fit_encoder_scale(samples, {});
  REQUIRE_FALSE(fit);
  CHECK_THAT(fit.error().reason, ContainsSubstring("on the way back") && ContainsSubstring("several sides"));
}

TEST_CASE("Where there is no clear period the reason is given") {
  const auto reason = [](const Scene& scene) {
    const auto fit = fit_encoder_scale(turn_past(scene), {});
    REQUIRE_FALSE(fit);
    return fit.error().reason;
  };
  CHECK_THAT(reason({.obstacle_bearings_rad = {}}), ContainsSubstring("sees nothing but noise"));
  CHECK_THAT(reason({.turns = 1.2}), ContainsSubstring("turn longer"));
  CHECK_THAT(reason({.turns = 0.01}), ContainsSubstring("not recorded"));
}

TEST_CASE("Surroundings that change while the robot turns are refused") {
  auto samples = turn_past({});
  const auto others = turn_past({.obstacle_bearings_rad = {5.5, 1.2}});
  for (std::size_t k = samples.size() / 3; k < samples.size(); ++k) {
    samples[k].light_bumper = k < 2 * samples.size() / 3 ? others[k].light_bumper : LightBumper{};
  }
  const auto fit = fit_encoder_scale(samples, {});
  REQUIRE_FALSE(fit);
  CHECK_THAT(fit.error().reason, ContainsSubstring("clear period"));
}

TEST_CASE("A turn outside what is plausible for the robot is refused") {
  CHECK_FALSE(fit_encoder_scale(turn_past({.ticks_per_turn = 2300.0}), {}));
  EncoderScaleOptions no_idea;
  no_idea.expected_ticks_per_turn = 0.0;
  const auto fit = fit_encoder_scale(turn_past({.ticks_per_turn = 2300.0}), no_idea);
  REQUIRE(fit);
  CHECK_THAT(fit->ticks_per_turn, WithinRel(2300.0, 0.002));
}

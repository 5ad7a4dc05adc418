#include "model/gap/regular_swing.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;
using namespace wheelwright::test;

namespace {

// What a swing adds to the travel of a wheel at a time, having come so far.
using Added = std::function<double(double time_s, double way_m)>;

double nothing(double, double) {
  return 0.0;
}

// As the model says but for what is added and for rough ground.
GapRun drive(const Added& added, double rough_m, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> rough(0.0, rough_m);
  WheelPair wandered_m;
  const auto beyond_m = [&](double time_s, const WheelPair& way_m) {
    const WheelPair so_far_m = wandered_m;
    wandered_m.left += rough(engine);
    wandered_m.right += rough(engine);
    return WheelPair{so_far_m.left + added(time_s, way_m.left + so_far_m.left),
                     so_far_m.right + added(time_s, way_m.right + so_far_m.right)};
  };
  return counted_run(counted_robot(), 2500, forward_at_two_speeds, beyond_m);
}

std::optional<RegularSwing> swing_in(const Added& added, double rough_m = 2e-5) {
  GapProblem problem({drive(added, rough_m, 1), drive(added, rough_m, 2)},
                     {counted_metres_per_tick, counted_metres_per_tick}, for_each_in_turn);
  problem.set_noise(problem.noise_left_by(counted_robot()));
  return regular_swing(problem, counted_robot(), problem.residuals(counted_robot()));
}

double sine_m(double amplitude_m, double turns) {
  return amplitude_m * std::sin(2.0 * std::numbers::pi * turns);
}

}  // namespace

TEST_CASE("A hum in a robot's speed is found with its beat") {
  const auto swing = swing_in([](double time_s, double) { return sine_m(0.003, time_s / 0.44); });
  REQUIRE(swing);
  CHECK(swing->over == RegularSwing::Over::time);
  CHECK_THAT(swing->period, WithinRel(0.44, 0.01));
  CHECK(swing->share > 0.3);
}

TEST_CASE("A slow pull to and fro is found with its beat") {
  const auto swing = swing_in([](double time_s, double) { return sine_m(0.03, time_s / 7.0); });
  REQUIRE(swing);
  CHECK(swing->over == RegularSwing::Over::time);
  CHECK_THAT(swing->period, WithinRel(7.0, 0.08));
}

TEST_CASE("Teeth that are felt in the way of a wheel are found with their distance") {
  const auto swing = swing_in([](double, double way_m) { return sine_m(0.001, way_m / 0.036); });
  REQUIRE(swing);
  CHECK(swing->over == RegularSwing::Over::way);
  CHECK_THAT(swing->period, WithinRel(0.036, 0.01));
}

TEST_CASE("Neither rough ground nor rounding to counts keeps a beat") {
  CHECK_FALSE(swing_in(nothing));
  CHECK_FALSE(swing_in(nothing, 2e-4));
  CHECK_FALSE(swing_in(nothing, 0.0));
}

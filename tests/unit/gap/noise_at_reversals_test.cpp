#include "model/gap/noise_at_reversals.hpp"

#include <algorithm>
#include <random>

#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;
using namespace wheelwright::test;

namespace {

constexpr int periods = 3000;
constexpr int reversals_of_a_run = 2 * (periods / 75 - 1);

WheelPair back_and_forth(int period) {
  const double speed_m_s = period / 75 % 2 == 0 ? 0.2 : -0.2;
  return {speed_m_s, speed_m_s};
}

// As the model says but for rough ground, and for play: a wheel stands until its motor has crossed it.
GapRun drive(const CommandOfPeriod& command_m_s, double play_m, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> rough(0.0, 1e-4);
  WheelPair wheel_m;
  WheelPair pushed_m;
  const auto beyond_m = [&](double, const WheelPair& way_m) {
    pushed_m.left += rough(engine);
    pushed_m.right += rough(engine);
    wheel_m.left = std::clamp(wheel_m.left, way_m.left - play_m / 2.0, way_m.left + play_m / 2.0);
    wheel_m.right = std::clamp(wheel_m.right, way_m.right - play_m / 2.0, way_m.right + play_m / 2.0);
    return WheelPair{wheel_m.left - way_m.left + pushed_m.left, wheel_m.right - way_m.right + pushed_m.right};
  };
  return counted_run(counted_robot(), periods, command_m_s, beyond_m);
}

NoiseAtReversals noise_of(const CommandOfPeriod& command_m_s, double play_m) {
  GapProblem problem({drive(command_m_s, play_m, 1)}, {counted_metres_per_tick}, for_each_in_turn);
  problem.set_noise(problem.noise_left_by(counted_robot()));
  return noise_at_reversals(problem, counted_robot(), problem.residuals(counted_robot()));
}

}  // namespace

TEST_CASE("Play that was taken for noise shows where the wheels change direction") {
  constexpr double play_m = 0.006;
  const NoiseAtReversals found = noise_of(back_and_forth, play_m);
  CHECK(found.reversals == reversals_of_a_run);
  CHECK_THAT(found.error_span_m, WithinRel(play_m, 0.3));
  CHECK(found.share > found.share_of_time);
  CHECK(too_much_for_noise(found));
}

TEST_CASE("Rough ground is the same where the wheels change direction and elsewhere") {
  const NoiseAtReversals found = noise_of(back_and_forth, 0.0);
  CHECK_THAT(found.times, WithinRel(1.0, 0.2));
  CHECK_THAT(found.share, WithinRel(found.share_of_time, 0.1));
  CHECK_FALSE(too_much_for_noise(found));
}

TEST_CASE("Nothing is said of reversals where no wheel changes direction") {
  CHECK(noise_of(forward_at_two_speeds, 0.006).reversals == 0);
}

TEST_CASE("A few reversals, or what only the counting shows, do not make noise doubtful") {
  const NoiseAtReversals doubtful{40, 4.0, 0.004, 0.5, 0.1};
  CHECK(too_much_for_noise(doubtful));
  NoiseAtReversals few = doubtful;
  few.reversals = 4;
  CHECK_FALSE(too_much_for_noise(few));
  NoiseAtReversals of_counting = doubtful;
  of_counting.error_span_m = 1e-4;
  CHECK_FALSE(too_much_for_noise(of_counting));
}

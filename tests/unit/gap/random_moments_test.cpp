#include "model/gap/random_moments.hpp"

#include <cmath>
#include <random>

#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;
using namespace wheelwright::test;

namespace {

constexpr int periods = 3000;

// Of a wheel that was held, at a few moments that nothing foretells.
struct Held {
  double loss_m = 0.0;
  double lasts_s = 0.1;
  double per_s = 0.0;
};

// As the model says but for moments, of the left wheel, and for rough ground.
GapRun drive(const Held& held, double rough_m, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> rough(0.0, rough_m);
  std::bernoulli_distribution begins(held.per_s * counted_period_s);
  const int lasts = static_cast<int>(std::lround(held.lasts_s / counted_period_s));
  int still_held = 0;  // periods
  WheelPair beyond_m;
  const auto next_m = [&](double, const WheelPair&) {
    const WheelPair so_far_m = beyond_m;
    still_held = still_held > 0 ? still_held - 1 : (begins(engine) ? lasts : 0);
    beyond_m.left += rough(engine) - (still_held > 0 ? held.loss_m / lasts : 0.0);
    beyond_m.right += rough(engine);
    return so_far_m;
  };
  return counted_run(counted_robot(), periods, forward_at_two_speeds, next_m, "run" + std::to_string(seed));
}

std::optional<RandomMoments> moments_in(const Held& held, double rough_m = 5e-5) {
  GapProblem problem({drive(held, rough_m, 1), drive(held, rough_m, 2)},
                     {counted_metres_per_tick, counted_metres_per_tick}, for_each_in_turn);
  problem.set_noise(problem.noise_left_by(counted_robot()));
  return random_moments(problem, counted_robot(), problem.residuals(counted_robot()));
}

}  // namespace

TEST_CASE("A wheel that is held now and then is found, with the moments") {
  const auto found = moments_in({.loss_m = 0.02, .per_s = 0.05});
  REQUIRE(found);
  CHECK(found->share > 0.5);
  CHECK(found->share_of_time < 0.05);
  REQUIRE(found->moments.size() >= 3);
  for (const auto& moment : found->moments) {
    CHECK((moment.run == "run1" || moment.run == "run2"));
    CHECK(moment.time_s >= 0.0);
    CHECK(moment.time_s < counted_period_s * periods);
  }
}

TEST_CASE("Noise that is there all the time has no moments") {
  CHECK_FALSE(moments_in({}));
  CHECK_FALSE(moments_in({}, 5e-4));
  CHECK_FALSE(moments_in({}, 0.0));
}

TEST_CASE("Slips of some millimetres, as a late clock makes them, are no such moments") {
  CHECK_FALSE(moments_in({.loss_m = 0.003, .lasts_s = 0.02, .per_s = 0.05}, 1e-5));
}

TEST_CASE("A wheel that is held all the time is rough ground") {
  CHECK_FALSE(moments_in({.loss_m = 0.02, .lasts_s = 0.1, .per_s = 4.0}));
}

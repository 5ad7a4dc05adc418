// Statistics of the predictive check on runs of a robot that does as the model says but for one thing.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "model/gap/adequacy/predictive_check.hpp"
#include "model/gap/adequacy/tail_probability.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;
using namespace wheelwright::test;

namespace {

constexpr int periods = 3000;

WheelPair back_and_forth(int period) {
  const double speed_m_s = period / 75 % 2 == 0 ? 0.2 : -0.2;
  return {speed_m_s, speed_m_s};
}

// What a robot's wheels do beyond the model, having come so far by it.
using Beyond = std::function<WheelPair(double time_s, const WheelPair& travel_m)>;

// `beyond(seed)` is a Beyond.
template <typename MakeBeyond>
PredictiveCheck check_of(const CommandOfPeriod& command_m_s, MakeBeyond beyond) {
  const auto run = [&](unsigned seed) {
    return counted_run(counted_robot(), periods, command_m_s, beyond(seed), "run" + std::to_string(seed));
  };
  FitProblem problem({run(1), run(2)}, {counted_metres_per_tick, counted_metres_per_tick}, serial_for);
  problem.set_noise(problem.noise_left_by(counted_robot()));
  return predictive_check(problem, counted_robot());
}

// Rough ground, and `held` periods at chance moments in which the left wheel loses travel.
struct Held {
  double loss_m = 0.0;
  double duration_s = 0.1;
  double per_s = 0.0;
  double rough_m = 5e-5;
};

Beyond held_now_and_then(const Held& held, unsigned seed) {
  const int duration = static_cast<int>(std::lround(held.duration_s / counted_period_s));
  return
      [=, engine = std::mt19937(seed), left = 0, beyond_m = WheelPair{}](double, const WheelPair&) mutable {
        std::normal_distribution<double> rough(0.0, held.rough_m);
        std::bernoulli_distribution begins(held.per_s * counted_period_s);
        const WheelPair now_m = beyond_m;
        left = left > 0 ? left - 1 : (begins(engine) ? duration : 0);
        beyond_m.left += rough(engine) - (left > 0 ? held.loss_m / duration : 0.0);
        beyond_m.right += rough(engine);
        return now_m;
      };
}

PredictiveCheck check_of(const Held& held) {
  return check_of(forward_at_two_speeds, [&](unsigned seed) { return held_now_and_then(held, seed); });
}

// Wheels that stand until their motor has crossed the play.
Beyond with_play(double play_m, unsigned seed) {
  return [=, engine = std::mt19937(seed), wheel_m = WheelPair{}, pushed_m = WheelPair{}](
             double, const WheelPair& travel_m) mutable {
    std::normal_distribution<double> rough(0.0, 1e-4);
    pushed_m.left += rough(engine);
    pushed_m.right += rough(engine);
    wheel_m.left = std::clamp(wheel_m.left, travel_m.left - play_m / 2.0, travel_m.left + play_m / 2.0);
    wheel_m.right = std::clamp(wheel_m.right, travel_m.right - play_m / 2.0, travel_m.right + play_m / 2.0);
    return WheelPair{wheel_m.left - travel_m.left + pushed_m.left,
                     wheel_m.right - travel_m.right + pushed_m.right};
  };
}

Beyond random_walk(double per_sqrt_s, unsigned seed) {
  const double step_m = per_sqrt_s * std::sqrt(counted_period_s);
  return [step_m, engine = std::mt19937(seed), beyond_m = WheelPair{}](double, const WheelPair&) mutable {
    std::normal_distribution<double> step(0.0, step_m);
    beyond_m.left += step(engine);
    beyond_m.right += step(engine);
    return beyond_m;
  };
}

// Readings that were taken a little sooner or later than their times say: off by the more, the faster the
// wheels turn.
Beyond read_at_other_times(double by_s, unsigned seed) {
  return
      [by_s, engine = std::mt19937(seed), last_m = WheelPair{}](double, const WheelPair& travel_m) mutable {
        std::normal_distribution<double> off(0.0, by_s / counted_period_s);
        const WheelPair beyond_m{off(engine) * (travel_m.left - last_m.left),
                                 off(engine) * (travel_m.right - last_m.right)};
        last_m = travel_m;
        return beyond_m;
      };
}

// The statistic of this name; the first of those that begin so.
const CheckStatistic* find(const PredictiveCheck& check, const std::string& name) {
  const auto found = std::ranges::find_if(
      check.statistics, [&](const CheckStatistic& statistic) { return statistic.name.starts_with(name); });
  return found == check.statistics.end() ? nullptr : &*found;
}

bool fails_by(const PredictiveCheck& check, const std::string& name) {
  const CheckStatistic* found = find(check, name);
  return found != nullptr && found->visible && found->p_value < check_level;
}

}  // namespace

TEST_CASE("A wheel that is held now and then is found, and the sentence gives the moments") {
  const auto check = check_of(Held{.loss_m = 0.02, .per_s = 0.05});
  CHECK_FALSE(check.passed);
  const CheckStatistic* found = find(check, "intermittent events, left wheel");
  REQUIRE(found != nullptr);
  CHECK(found->visible);
  CHECK(found->share_of_gap > 0.5);
  CHECK(found->share_of_time < 0.05);
  CHECK_THAT(found->sentence, ContainsSubstring("run1 at ") || ContainsSubstring("run2 at "));
  CHECK_FALSE(fails_by(check, "intermittent events, right wheel"));
}

TEST_CASE("Noise that is there all the time has no events, however large it is") {
  for (const double rough_m : {0.0, 5e-5, 5e-4}) {
    CAPTURE(rough_m);
    CHECK_FALSE(fails_by(check_of(Held{.rough_m = rough_m}), "intermittent events"));
  }
}

TEST_CASE(
    "Noise that grows with the speed has no events where the robot is seldom fast, and held wheels there "
    "stay found") {
  const auto seldom_fast = [](int period) {
    const double speed_m_s = period / 150 % 8 == 0 ? 0.4 : 0.04;
    return WheelPair{speed_m_s, speed_m_s};
  };
  CHECK_FALSE(fails_by(check_of(seldom_fast, [](unsigned seed) { return read_at_other_times(0.015, seed); }),
                       "intermittent events"));
  const Held held{.loss_m = 0.05, .per_s = 0.05};
  CHECK(fails_by(check_of(seldom_fast, [&](unsigned seed) { return held_now_and_then(held, seed); }),
                 "intermittent events, left wheel"));
}

TEST_CASE("A wheel that is held all the time is rough ground, and has no events") {
  CHECK_FALSE(fails_by(check_of(Held{.loss_m = 0.02, .per_s = 4.0}), "intermittent events"));
}

TEST_CASE("Slips of a millimetre, as a late clock makes them, are no events") {
  const Held slips{.loss_m = 0.001, .duration_s = 0.02, .per_s = 0.05, .rough_m = 1e-5};
  CHECK_FALSE(fails_by(check_of(slips), "intermittent events"));
}

TEST_CASE("Play that was taken for noise shows where the wheels change direction") {
  const auto check = check_of(back_and_forth, [](unsigned seed) { return with_play(0.006, seed); });
  CHECK_FALSE(check.passed);
  CHECK(fails_by(check, "residual after reversals, left wheel"));
  CHECK(fails_by(check, "residual after reversals, right wheel"));
  const CheckStatistic* found = find(check, "residual after reversals");
  CHECK(found->share_of_gap > found->share_of_time);
}

TEST_CASE("Rough ground is the same where the wheels change direction and elsewhere") {
  const auto check = check_of(back_and_forth, [](unsigned seed) { return with_play(0.0, seed); });
  REQUIRE(find(check, "residual after reversals") != nullptr);
  CHECK_FALSE(fails_by(check, "residual after reversals"));
}

TEST_CASE("Nothing is said of reversals where no wheel changes direction") {
  CHECK(find(check_of(Held{}), "residual after reversals") == nullptr);
}

TEST_CASE("A robot that drifts further than sound robots do is not called sound") {
  const auto drifting = [](double per_sqrt_s) {
    return check_of(forward_at_two_speeds, [=](unsigned seed) { return random_walk(per_sqrt_s, seed); });
  };
  const auto far = drifting(0.04);
  CHECK(fails_by(far, "drift"));
  CHECK_THAT(find(far, "drift")->sentence, ContainsSubstring("mm within a second"));
  CHECK_FALSE(fails_by(drifting(0.003), "drift"));
}

TEST_CASE("A rate of drift is found within what the readings allow") {
  for (const double per_sqrt_s : {0.003, 0.04}) {
    const auto check =
        check_of(forward_at_two_speeds, [=](unsigned seed) { return random_walk(per_sqrt_s, seed); });
    CHECK_THAT(find(check, "drift")->detail.front().second, WithinRel(per_sqrt_s, 0.3));
  }
}

TEST_CASE("A hum in a robot's speed and teeth in a wheel's travel are found with their periods") {
  const auto swings = [](unsigned seed, double amplitude_m, auto turns) {
    return [=, engine = std::mt19937(seed), walk_m = WheelPair{}](double time_s,
                                                                  const WheelPair& travel_m) mutable {
      std::normal_distribution<double> rough(0.0, 2e-5);
      walk_m.left += rough(engine);
      walk_m.right += rough(engine);
      const auto sine = [&](double wheel_m) {
        return amplitude_m * std::sin(2.0 * std::numbers::pi * turns(time_s, wheel_m));
      };
      return WheelPair{walk_m.left + sine(travel_m.left), walk_m.right + sine(travel_m.right)};
    };
  };
  const auto hum = check_of(forward_at_two_speeds, [&](unsigned seed) {
    return swings(seed, 0.004, [](double time_s, double) { return time_s / 0.44; });
  });
  CHECK(fails_by(hum, "periodic residual, left wheel"));
  CHECK_THAT(find(hum, "periodic residual, left wheel")->detail.front().second, WithinRel(0.44, 0.01));
  const auto teeth = check_of(forward_at_two_speeds, [&](unsigned seed) {
    return swings(seed, 0.004, [](double, double travel_m) { return travel_m / 0.036; });
  });
  CHECK(fails_by(teeth, "periodic residual over travel, left wheel"));
  CHECK_THAT(find(teeth, "periodic residual over travel, left wheel")->detail.front().second,
             WithinRel(0.036, 0.01));
}

TEST_CASE(
    "The tail of the Poisson distribution agrees with its complement, and far out with its first term") {
  CHECK_THAT(poisson_tail(1, 0.5), WithinRel(1.0 - std::exp(-0.5), 1e-12));
  CHECK_THAT(poisson_tail(3, 2.0), WithinRel(1.0 - 5.0 * std::exp(-2.0), 1e-12));
  CHECK_THAT(poisson_tail(4, 1e-4), WithinRel(1e-16 / 24.0, 1e-3));
}

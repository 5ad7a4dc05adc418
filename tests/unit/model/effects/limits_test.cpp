// What limits of speed and of acceleration do to a motion.
#include <algorithm>
#include <cmath>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/one_effect.hpp"

using namespace wheelwright;
using test::one_effect_period_s;
using test::only;
using test::speed_after;

TEST_CASE("A limit of acceleration gets less with speed by what drags, and braking more") {
  ModelSimulation even = only({"rate_limit", "speed", {0.5, 0.0}});
  CHECK_THAT(speed_after(even, 0.4, 10), WithinAbs(10 * one_effect_period_s * 0.5, 1e-12));
  ModelSimulation dragged = only({"rate_limit", "speed", {0.5, 2.0}});
  const auto approach = [](double to_m_s, int periods) {
    return to_m_s * (1.0 - std::pow(1.0 - 2.0 * one_effect_period_s, periods));
  };
  CHECK_THAT(speed_after(dragged, 0.2, 10), WithinAbs(approach(0.25, 10), 1e-12));  // 0.5 / 2 m/s at last
  const double before_m_s = speed_after(dragged, 0.2, 200);
  CHECK_THAT(before_m_s, WithinAbs(0.2, 1e-12));
  CHECK_THAT(speed_after(dragged, 0.0, 1), WithinAbs(0.2 - one_effect_period_s * (0.5 + 2.0 * 0.2), 1e-12));
}

TEST_CASE("A ramp within periods brings the mean speed that its way in small steps has") {
  constexpr double limit_m_s2 = 0.7;
  ModelSimulation ramp = only({"rate_limit", "ramp", {limit_m_s2, 0.0}});
  double wanted_m_s = 0.0;
  double speed_m_s = 0.0;
  for (int k = 0; k < 60; ++k) {
    if (k % 4 == 0) wanted_m_s = 0.2 * std::sin(1.7 * k);
    constexpr int steps = 2000;
    constexpr double step_s = one_effect_period_s / steps;
    double way_m = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double before_m_s = speed_m_s;
      speed_m_s += std::clamp(wanted_m_s - speed_m_s, -limit_m_s2 * step_s, limit_m_s2 * step_s);
      way_m += step_s * 0.5 * (before_m_s + speed_m_s);
    }
    INFO("period " << k);
    CHECK_THAT(ramp.step({wanted_m_s, wanted_m_s}).wheel_m_s.left,
               WithinAbs(way_m / one_effect_period_s, 1e-5));
  }
}

TEST_CASE("A limit is met sharply or by a knee") {
  ModelSimulation sharp = only({"saturation", "command", {0.2, 0.0, 0.0}});
  CHECK(speed_after(sharp, 0.2, 1) == 0.2);
  CHECK(speed_after(sharp, 0.3, 1) == 0.2);
  ModelSimulation round = only({"saturation", "command", {0.2, 0.0, 0.1}});
  CHECK_THAT(speed_after(round, 0.2, 1), WithinAbs(0.2 * std::pow(2.0, -0.1), 1e-12));
  CHECK_THAT(speed_after(round, 0.05, 1), WithinAbs(0.05, 1e-7));
}

TEST_CASE("What never comes near to level is a bend of the gain and no saturation") {
  const EffectInfo* info = find_effect("saturation");
  const auto is_a_limit = [&](double limit_m_s, double knee, double largest_command_m_s) {
    const std::vector<double> parameters{limit_m_s, 0.0, knee};
    return info->in_character({parameters, 0}, largest_command_m_s);
  };
  CHECK(is_a_limit(0.3, 0.05, 0.4));
  CHECK(is_a_limit(0.4, 0.05, 0.3));  // what it takes to be there in time may be more
  CHECK_FALSE(is_a_limit(0.7, 0.05, 0.3));
  CHECK_FALSE(is_a_limit(0.5, 0.5, 0.45));
  CHECK(is_a_limit(0.25, 0.5, 0.45));
}

TEST_CASE("A limit of acceleration whose drag ends at the speeds asked for is a limit of speed") {
  const EffectInfo* info = find_effect("rate_limit");
  const auto is_a_limit_of_acceleration = [&](double limit_m_s2, double drag_per_s) {
    return info->in_character({std::vector{limit_m_s2, drag_per_s}, 0}, 0.5);
  };
  CHECK(is_a_limit_of_acceleration(0.3, 0.0));
  CHECK(is_a_limit_of_acceleration(0.3, 0.3));  // up to 1 m/s
  CHECK(is_a_limit_of_acceleration(0.3, 0.5));  // a current limit and a motor's drag: slowly up to 0.6 m/s
  CHECK_FALSE(is_a_limit_of_acceleration(0.33, 0.65));
}

// What effects of commands and wheels do to a motion, against what can be said of it on paper.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/testability.hpp"
#include "model/gap/figures/figures.hpp"
#include "model/gap/fit/trial_model.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/one_effect.hpp"

using namespace wheelwright;
using test::only;
using test::speed_after;

namespace {

constexpr double period_s = test::one_effect_period_s;

// Share of the way that a first-order lag (backward Euler) has left after some periods.
double left_of_way(double lag_s, int periods) {
  return std::pow(lag_s / (period_s + lag_s), periods);
}

constexpr double motor_lag_s = 0.04;
constexpr double rolling_time_s = 1.5;

// A lag of the first order and nothing else.
LinearModel lagging() {
  const double share = -std::expm1(-period_s / motor_lag_s);
  const WheelResponse wheel{{share}, {0.0}, {1.0 - share}};
  return {ModelType::arma, period_s, 0.258, wheel, {{0.0}, {share}, {1.0 - share}}};
}

// A motor that carries current in the direction of its voltage alone, with a load that is constant while it
// goes forward: its equation of motion in small steps. The voltage turns round at half the speed, but drives
// a wheel the other way only where that is slow enough.
struct UnpoweredMotor {
  double load_m_s = 0.0;
  double reverses_below_m_s = 3.0;
  double speed_m_s = 0.0;
  double way_m = 0.0;

  double moved_m(double command_m_s) {
    constexpr int steps = 200;
    constexpr double step_s = period_s / steps;
    const double before_m = way_m;
    for (int i = 0; i < steps; ++i) {
      const double powered_m_s2 = (command_m_s - speed_m_s) / motor_lag_s;
      const double rolling_m_s2 = -speed_m_s / rolling_time_s;
      const bool waits = command_m_s < 0.0 && speed_m_s > reverses_below_m_s;
      const bool brakes = !waits && command_m_s < 0.5 * speed_m_s;
      const double motor_m_s2 = brakes ? powered_m_s2 : std::max(powered_m_s2, rolling_m_s2);
      speed_m_s += step_s * (motor_m_s2 - load_m_s / motor_lag_s);
      way_m += step_s * speed_m_s;
    }
    return way_m - before_m;
  }
};

}  // namespace

TEST_CASE("A drive with an asymmetric response speeds up with one lag and slows down with the other") {
  ModelSimulation simulation = only({"asymmetric_response", "speed", {0.1, 0.05}});
  CHECK_THAT(speed_after(simulation, 0.2, 10), WithinAbs(0.2 * (1.0 - left_of_way(0.05, 10)), 1e-12));
  const double before_m_s = speed_after(simulation, 0.2, 200);
  CHECK_THAT(speed_after(simulation, 0.0, 10), WithinAbs(before_m_s * left_of_way(0.15, 10), 1e-12));
}

TEST_CASE("A motor that cannot brake rolls on until it is as slow as it should be") {
  ModelSimulation simulation = only({"asymmetric_response", "speed_coasting", {1.0, 0.0, 0.5, 3.0}});
  CHECK(speed_after(simulation, 0.2, 1) == 0.2);
  CHECK_THAT(speed_after(simulation, 0.15, 10), WithinAbs(0.2 * left_of_way(1.0, 10), 1e-12));
  CHECK(speed_after(simulation, 0.15, 20) == 0.15);
  CHECK(speed_after(simulation, 0.0, 1) == 0.0);  // less than half as fast: it brakes
}

TEST_CASE("A motor that brakes for much less than its speed rolls on from where that is not much less") {
  ModelSimulation simulation = only({"asymmetric_response", "speed_coasting", {1.0, 0.1, 0.5, 3.0}});
  const double before_m_s = speed_after(simulation, -0.2, 300);
  const double braked_m_s = speed_after(simulation, -0.05, 7);
  CHECK_THAT(braked_m_s, WithinAbs(-0.05 + (before_m_s + 0.05) * left_of_way(0.1, 7), 1e-12));
  CHECK(braked_m_s > -0.1);
  CHECK_THAT(speed_after(simulation, -0.05, 20), WithinAbs(braked_m_s * left_of_way(1.0, 20), 1e-12));
}

TEST_CASE(
    "A load slows a wheel without current by all its force, and the same wheel under power by its lag") {
  const EffectSetting coasting{
      "asymmetric_response", "motor_coasting", {rolling_time_s, motor_lag_s, 0.5, 3.0}};
  const EffectSetting uphill{"floor_slope", "wheel", {-0.004, 0.0}};
  const EffectSetting downhill{"floor_slope", "wheel", {0.002, 0.0}};
  const EffectSetting friction{"coulomb_friction", "", {0.004, motor_lag_s}};
  const std::vector<std::pair<EffectSetting, double>> loads{
      {uphill, 0.004}, {downhill, -0.002}, {friction, 0.004}};
  for (const auto& [load, load_m_s] : loads) {
    INFO(load.name << " of " << load_m_s);
    ModelSimulation simulation(lagging(), std::vector{coasting, load});
    UnpoweredMotor motor{.load_m_s = load_m_s};
    double way_m = 0.0;
    double settled_m = 0.0;  // a lag in steps of a period lags by another while
    double slowest_m_s = 1.0;
    for (int k = 0; k < 300; ++k) {
      const double command_m_s = k < 80 ? 0.2 : k < 140 ? 0.13 : k < 220 ? 0.18 : 0.05;
      way_m += period_s * simulation.step({command_m_s, command_m_s}).wheel_m_s.left;
      const double moved_m = motor.moved_m(command_m_s);
      if (k >= 80 && k < 140) slowest_m_s = std::min(slowest_m_s, moved_m / period_s);
      REQUIRE_THAT(simulation.distance_m().left, WithinAbs(way_m, 1e-12));
      if (k == 79) settled_m = way_m - motor.way_m;
      if (k >= 80) REQUIRE_THAT(way_m, WithinAbs(motor.way_m + settled_m, 0.0015));
    }
    CHECK(slowest_m_s >
          (load_m_s > 0.0 ? 0.125 : 0.135));  // downhill it is not slow enough for power within a second
  }
}

TEST_CASE("A drive that waits for its wheel to slow down lets it roll before it drives it the other way") {
  constexpr double reverses_below_m_s = 0.03;
  ModelSimulation simulation(
      lagging(),
      std::vector<EffectSetting>{
          {"asymmetric_response", "motor_coasting", {rolling_time_s, motor_lag_s, 0.5, reverses_below_m_s}}});
  UnpoweredMotor motor{.reverses_below_m_s = reverses_below_m_s};
  double way_m = 0.0;
  double settled_m = 0.0;  // a lag in steps of a period lags by another while
  int rolled = 0;
  for (int k = 0; k < 400; ++k) {
    const double command_m_s = k < 80 ? 0.2 : -0.15;
    const double speed_m_s = simulation.step({command_m_s, command_m_s}).wheel_m_s.left;
    way_m += period_s * speed_m_s;
    motor.moved_m(command_m_s);
    if (k >= 80 && speed_m_s > 0.0) ++rolled;
    if (k == 79) settled_m = way_m - motor.way_m;
    if (k >= 80) REQUIRE_THAT(way_m, WithinAbs(motor.way_m + settled_m, 0.003));
  }
  CHECK_THAT(rolled * period_s, WithinAbs(rolling_time_s * std::log(0.2 / reverses_below_m_s), 0.1));
  ModelSimulation command = only({"asymmetric_response", "speed_coasting", {1.0, 0.0, 0.5, 0.1}});
  speed_after(command, 0.2, 1);
  CHECK_THAT(speed_after(command, -0.2, 30), WithinAbs(0.2 * left_of_way(1.0, 30), 1e-12));
  CHECK(speed_after(command, -0.2, 20) == -0.2);
}

TEST_CASE("A motor acts before its loads, in whatever order a model lists them") {
  const EffectSetting coasting{
      "asymmetric_response", "motor_coasting", {rolling_time_s, motor_lag_s, 0.5, 3.0}};
  const EffectSetting friction{"coulomb_friction", "", {0.004, motor_lag_s}};
  ModelSimulation one(lagging(), std::vector{coasting, friction});
  ModelSimulation other(lagging(), std::vector{friction, coasting});
  for (int k = 0; k < 200; ++k) {
    const double command_m_s = k < 80 ? 0.2 : 0.05;
    REQUIRE(one.step({command_m_s, command_m_s}).wheel_m_s.left ==
            other.step({command_m_s, command_m_s}).wheel_m_s.left);
  }
}

TEST_CASE("A motor at its full voltage approaches its limit with its own lag") {
  ModelSimulation simulation = only({"saturation", "speed", {0.2, 0.1, 0.0}});
  CHECK_THAT(speed_after(simulation, 0.4, 10), WithinAbs(0.2 * (1.0 - left_of_way(0.1, 10)), 1e-12));
  CHECK(speed_after(simulation, 0.4, 500) <= 0.2);
}

TEST_CASE("Speed is lost in a curve sharper than the onset, and the turn rate stays") {
  const auto motion = [](const EffectSetting& effect, WheelPair command_m_s) {
    return only(effect).step(command_m_s).twist;
  };
  const WheelPair curve_m_s{0.074, 0.126};  // 0.1 m/s and 0.2016 rad/s: a radius of 0.5 m
  const double turn_rate_rad_s = 0.052 / 0.258;
  const Twist sharp = motion({"turn_speed_loss", "absolute", {0.5, 1.5}}, curve_m_s);
  CHECK_THAT(sharp.w_rad_s, WithinAbs(turn_rate_rad_s, 1e-12));
  CHECK_THAT(sharp.v_m_s, WithinAbs(0.1 - 0.2 * 0.5 * (turn_rate_rad_s - 0.15), 1e-12));
  const Twist share = motion({"turn_speed_loss", "relative", {0.5, 0.0}}, curve_m_s);
  CHECK_THAT(share.v_m_s, WithinAbs(0.1 * (1.0 - 0.5 * turn_rate_rad_s), 1e-12));
  CHECK_THAT(motion({"turn_speed_loss", "absolute", {0.5, 2.1}}, curve_m_s).v_m_s, WithinAbs(0.1, 1e-12));
}

TEST_CASE("A turn that is dragged is shared with the wheels, one that is scrubbed loses a part") {
  const auto turn_rate = [](const std::string& variant, double loss, double square) {
    return only({"turn_scrub", variant, {loss, square, 0.0}}).step({-0.129, 0.129}).twist.w_rad_s;
  };
  CHECK_THAT(turn_rate("", 0.2, 0.0), WithinAbs(0.8, 1e-12));
  CHECK_THAT(turn_rate("drag", 0.2, 0.0), WithinAbs(1.0 / 1.2, 1e-12));
  CHECK_THAT(turn_rate("drag", 0.0, 0.25), WithinAbs(0.8, 1e-12));
}

TEST_CASE("A dead zone takes its threshold from all commands, from some above it, or from none") {
  const auto speed = [](double taper, double command_m_s) {
    ModelSimulation simulation = only({"dead_zone", "", {0.02, taper}});
    return speed_after(simulation, command_m_s, 1);
  };
  for (const double taper : {0.02, 0.5, 1.0}) {
    CHECK(speed(taper, 0.015) == 0.0);
    CHECK(speed(taper, -0.015) == 0.0);
  }
  CHECK(speed(0.02, 0.03) == 0.03);
  CHECK_THAT(speed(0.5, 0.03), WithinAbs(0.02, 1e-12));
  CHECK_THAT(speed(0.5, -0.03), WithinAbs(-0.02, 1e-12));
  CHECK(speed(0.5, 0.05) == 0.05);
  CHECK_THAT(speed(1.0, 0.05), WithinAbs(0.03, 1e-12));
}

TEST_CASE("Play is lost on reversal, and where little brakes the wheel, on starting again") {
  const auto way_m = [](ModelSimulation& simulation, double command_m_s, int periods) {
    double sum = 0.0;
    for (int k = 0; k < periods; ++k) sum += period_s * simulation.step({command_m_s, 0.0}).wheel_m_s.left;
    return sum;
  };
  const double there_m = 50 * period_s * 0.1;
  // At the largest rate a wheel of 0.1 m/s rolls on by 8 um: as good as at once.
  ModelSimulation stands_at_once = only({"backlash", "wheel", {0.004, 300.0, 1.0}});
  CHECK_THAT(way_m(stands_at_once, 0.1, 50), WithinAbs(there_m, 1e-5));
  CHECK_THAT(way_m(stands_at_once, 0.0, 50), WithinAbs(0.0, 1e-5));
  CHECK_THAT(way_m(stands_at_once, 0.1, 50), WithinAbs(there_m, 1e-5));
  CHECK_THAT(way_m(stands_at_once, -0.1, 50), WithinAbs(-there_m + 0.004, 1e-5));
  // A speed that falls to 1/e in 0.1 s carries 0.1 m/s through 10 mm: more than the gap.
  ModelSimulation runs_on = only({"backlash", "wheel", {0.004, 10.0, 1.0}});
  CHECK_THAT(way_m(runs_on, 0.1, 50), WithinAbs(there_m, 1e-9));
  CHECK_THAT(way_m(runs_on, 0.0, 50), WithinAbs(0.004, 1e-9));
  CHECK_THAT(way_m(runs_on, 0.1, 50), WithinAbs(there_m - 0.004, 1e-9));
  // In the middle of the gap, half of it is lost either way.
  ModelSimulation from_the_middle = only({"backlash", "wheel", {0.004, 300.0, 0.5}});
  CHECK_THAT(way_m(from_the_middle, 0.1, 50), WithinAbs(there_m - 0.002, 1e-5));
  CHECK_THAT(way_m(from_the_middle, -0.1, 50), WithinAbs(-there_m + 0.004, 1e-5));
}

TEST_CASE(
    "Play before the response is crossed by the command, and the robot lags behind what comes through") {
  ModelSimulation simulation(lagging(),
                             std::vector{EffectSetting{"backlash", "command", {0.004, 300.0, 1.0}}});
  const double forward_m_s = speed_after(simulation, 0.1, 200);
  CHECK_THAT(forward_m_s, WithinAbs(0.1, 1e-6));
  // A command of -0.1 m/s crosses 4 mm in 2.22 periods of 18 ms; of the third one the rest comes through.
  const double kept = std::exp(-period_s / motor_lag_s);
  double lagged_m_s = forward_m_s;
  for (const double through_m_s : {0.0, 0.0, -0.1 * (3.0 - 0.004 / (0.1 * period_s)), -0.1, -0.1}) {
    lagged_m_s = kept * lagged_m_s + (1.0 - kept) * through_m_s;
    CHECK_THAT(speed_after(simulation, -0.1, 1), WithinAbs(lagged_m_s, 1e-3));
  }
}

TEST_CASE("A drive that warms by use changes its gain while it works and gets it back at rest") {
  ModelSimulation simulation = only({"gain_drift", "use", {0.1, 10.0}});
  const int longest = 10000;
  CHECK_THAT(speed_after(simulation, 0.2, longest), WithinAbs(0.2 * 1.1, 1e-6));
  speed_after(simulation, 0.0, longest);
  CHECK_THAT(speed_after(simulation, 0.2, 1), WithinAbs(0.2, 1e-6));
  CHECK_THAT(speed_after(simulation, 0.1, longest), WithinAbs(0.1 * 1.05, 1e-6));
}

TEST_CASE("A gain that bends never makes a wheel slower for a larger command") {
  for (const double curvature : {-1.0, 0.5, 3.0}) {
    for (const double cubic : {-3.0, 0.0, 3.0}) {
      INFO(curvature << " " << cubic);
      ModelSimulation simulation = only({"gain_curve", "command", {curvature, cubic}});
      double before_m_s = 0.0;
      for (int step = 1; step <= 60; ++step) {
        const double speed_m_s = speed_after(simulation, 0.01 * step, 1);
        CHECK(speed_m_s >= before_m_s);
        before_m_s = speed_m_s;
      }
    }
  }
  ModelSimulation steep = only({"gain_curve", "command", {3.0, 0.0}});
  CHECK(speed_after(steep, 0.34, 1) > speed_after(steep, 0.3, 1));
  CHECK(speed_after(steep, 0.4, 1) == speed_after(steep, 0.36, 1));
  ModelSimulation parabola = only({"gain_curve", "command", {0.5, 0.0}});
  CHECK_THAT(speed_after(parabola, 0.2, 1), WithinAbs(0.2 * (1.0 - 0.5 * 0.2), 1e-12));
}

TEST_CASE("Steps act on the command as it was sent, after whatever effect they were found") {
  gap::TrialModel model = gap::first_guess({}, period_s, 0.258, 0.06, 2.0 * period_s);
  const EffectInfo* gain = find_effect("direction_gain");
  const EffectInfo* steps = find_effect("command_quantization");
  model.effects = {{gain, 0, {-0.1}}, {steps, 0, {0.02, 0.5}}};
  ModelSimulation simulation = model.simulation();
  // 0.1 m/s backward is five steps, and nine tenths of that; of 0.09 m/s, the steps would make 0.1 or 0.08.
  CHECK_THAT(speed_after(simulation, -0.1, 500), WithinAbs(-0.09, 1e-9));
}

TEST_CASE("Wheels turn the same whether the place of their robot is kept or not") {
  ModelSimulation with = only({"saturation", "speed", {0.2, 0.1, 0.05}});
  ModelSimulation without = only({"saturation", "speed", {0.2, 0.1, 0.05}});
  without.leave_out_place();
  for (int k = 0; k < 100; ++k) {
    with.step({0.3, 0.1});
    without.step({0.3, 0.1});
  }
  CHECK(without.distance_m().left == with.distance_m().left);
  CHECK(without.distance_m().right == with.distance_m().right);
  CHECK(without.pose().theta_rad == with.pose().theta_rad);
  CHECK(without.pose().x_m == 0.0);
  CHECK(with.pose().x_m != 0.0);
}

TEST_CASE("Logs without poses show what loads the wheels, and say that the body is not seen") {
  test::GapCaseSpec spec;
  spec.name = "clean";
  spec.channels = test::Channels::ticks;
  spec.runs = 2;
  spec.seconds = 30.0;
  const auto contents = gap::testability(test::make_gap_case(spec).runs);
  const auto candidate = [&](std::string_view name) {
    return std::ranges::count(contents.candidate_effects, name,
                              [](const EffectInfo* info) -> std::string_view { return info->name; }) > 0;
  };
  const auto listed = [&](std::string_view name) {
    return std::ranges::count(contents.untestable, name, &gap::Untestable::effect) > 0;
  };
  CHECK(candidate("turn_scrub"));
  CHECK(listed("turn_scrub"));
  CHECK_FALSE(candidate("lever_arm"));
  CHECK(listed("lever_arm"));
  CHECK(candidate("dead_zone"));
  CHECK_FALSE(listed("dead_zone"));
}

TEST_CASE("A figure is above the noise where it was larger than its floor before the analysis") {
  gap::GapFigures figures;
  figures.before.distance_rms_m = 0.004;
  figures.floor.distance_rms_m = 0.005;
  CHECK_FALSE(gap::some_figure_above_noise(figures));
  figures.before.position_rms_m = AtHorizon{10.0, 0.008};
  figures.floor.position_rms_m = AtHorizon{10.0, 0.007};
  CHECK(gap::some_figure_above_noise(figures));
}

TEST_CASE("Motors that are mounted as in a mirror are stronger one forward and the other in reverse") {
  ModelSimulation simulation = only({"direction_gain", "each_wheel", {0.05, -0.03}});
  const WheelPair forward = simulation.step({0.2, 0.2}).wheel_m_s;
  CHECK_THAT(forward.left, WithinAbs(0.2, 1e-12));
  CHECK_THAT(forward.right, WithinAbs(0.2, 1e-12));
  const WheelPair reverse = simulation.step({-0.2, -0.2}).wheel_m_s;
  CHECK_THAT(reverse.left, WithinAbs(-0.21, 1e-12));
  CHECK_THAT(reverse.right, WithinAbs(-0.194, 1e-12));
}

// What effects do to a motion, against what can be said of it on paper.
#include <cmath>
#include <numbers>

#include "model/drive_log.hpp"
#include "model/effect_library.hpp"
#include "model/gap/gap_figures.hpp"
#include "model/gap/testability.hpp"
#include "model/gap/trial_model.hpp"
#include "model/model_simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;

// A wheel that does at once what it is told, but for the effect.
ModelSimulation only(const EffectSetting& effect) {
  const LinearModel core{ModelType::arma, period_s, 0.258, {{1.0}, {0.0}, {}}, {{0.0}, {1.0}, {}}};
  return {core, std::vector{effect}};
}

double speed_after(ModelSimulation& simulation, double command_m_s, int periods) {
  double speed_m_s = 0.0;
  for (int k = 0; k < periods; ++k) speed_m_s = simulation.step({command_m_s, command_m_s}).wheel_m_s.left;
  return speed_m_s;
}

// Share of the way that a first-order lag (backward Euler) has left after some periods.
double left_of_way(double lag_s, int periods) {
  return std::pow(lag_s / (period_s + lag_s), periods);
}

}  // namespace

TEST_CASE("A drive with an asymmetric response speeds up with one lag and slows down with the other") {
  ModelSimulation simulation = only({"asymmetric_response", "speed", {0.1, 0.05}});
  CHECK_THAT(speed_after(simulation, 0.2, 10), WithinAbs(0.2 * (1.0 - left_of_way(0.05, 10)), 1e-12));
  const double before_m_s = speed_after(simulation, 0.2, 200);
  CHECK_THAT(speed_after(simulation, 0.0, 10), WithinAbs(before_m_s * left_of_way(0.15, 10), 1e-12));
}

TEST_CASE("A motor that cannot brake rolls on until it is as slow as it should be") {
  ModelSimulation simulation = only({"asymmetric_response", "speed_coasting", {1.0, 0.0, 0.5}});
  CHECK(speed_after(simulation, 0.2, 1) == 0.2);
  CHECK_THAT(speed_after(simulation, 0.15, 10), WithinAbs(0.2 * left_of_way(1.0, 10), 1e-12));
  CHECK(speed_after(simulation, 0.15, 20) == 0.15);
  CHECK(speed_after(simulation, 0.0, 1) == 0.0);  // less than half as fast: it brakes
}

TEST_CASE("A motor that brakes for much less than its speed rolls on from where that is not much less") {
  ModelSimulation simulation = only({"asymmetric_response", "speed_coasting", {1.0, 0.1, 0.5}});
  const double before_m_s = speed_after(simulation, -0.2, 300);
  const double braked_m_s = speed_after(simulation, -0.05, 7);
  CHECK_THAT(braked_m_s, WithinAbs(-0.05 + (before_m_s + 0.05) * left_of_way(0.1, 7), 1e-12));
  CHECK(braked_m_s > -0.1);
  CHECK_THAT(speed_after(simulation, -0.05, 20), WithinAbs(braked_m_s * left_of_way(1.0, 20), 1e-12));
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

TEST_CASE("A limit of acceleration gets less with speed by what drags, and braking more") {
  ModelSimulation even = only({"rate_limit", "speed", {0.5, 0.0}});
  CHECK_THAT(speed_after(even, 0.4, 10), WithinAbs(10 * period_s * 0.5, 1e-12));
  ModelSimulation dragged = only({"rate_limit", "speed", {0.5, 2.0}});
  const auto approach = [](double to_m_s, int periods) {
    return to_m_s * (1.0 - std::pow(1.0 - 2.0 * period_s, periods));
  };
  CHECK_THAT(speed_after(dragged, 0.2, 10), WithinAbs(approach(0.25, 10), 1e-12));  // 0.5 / 2 m/s at last
  const double before_m_s = speed_after(dragged, 0.2, 200);
  CHECK_THAT(before_m_s, WithinAbs(0.2, 1e-12));
  CHECK_THAT(speed_after(dragged, 0.0, 1), WithinAbs(0.2 - period_s * (0.5 + 2.0 * 0.2), 1e-12));
}

TEST_CASE("A limit is met sharply or by a knee") {
  ModelSimulation sharp = only({"saturation", "command", {0.2, 0.0, 0.0}});
  CHECK(speed_after(sharp, 0.2, 1) == 0.2);
  CHECK(speed_after(sharp, 0.3, 1) == 0.2);
  ModelSimulation round = only({"saturation", "command", {0.2, 0.0, 0.1}});
  CHECK_THAT(speed_after(round, 0.2, 1), WithinAbs(0.2 * std::pow(2.0, -0.1), 1e-12));
  CHECK_THAT(speed_after(round, 0.05, 1), WithinAbs(0.05, 1e-7));
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

TEST_CASE("A region of the floor is a rectangle that may lie askew") {
  // One metre by half a metre around (1, 0), its length along y.
  ModelSimulation simulation =
      only({"surface_patch", "floor", {-0.2, 1.0, 0.0, 1.0, 0.5, 0.5 * std::numbers::pi}});
  const auto speed_at = [&](double x_m, double y_m) {
    simulation.reset({x_m, y_m, 0.0});
    return simulation.step({0.1, 0.1}).twist.v_m_s;
  };
  CHECK_THAT(speed_at(1.0, 0.0), WithinAbs(0.08, 1e-9));
  CHECK_THAT(speed_at(1.2, 0.45), WithinAbs(0.08, 1e-9));
  CHECK_THAT(speed_at(1.3, 0.0), WithinAbs(0.1, 1e-9));
  CHECK_THAT(speed_at(1.0, 0.55), WithinAbs(0.1, 1e-9));
}

TEST_CASE("A region of the floor may be an ellipse that lies askew") {
  ModelSimulation simulation =
      only({"surface_patch", "floor_round", {-0.2, 1.0, 0.0, 1.0, 0.5, 0.5 * std::numbers::pi}});
  const auto speed_at = [&](double x_m, double y_m) {
    simulation.reset({x_m, y_m, 0.0});
    return simulation.step({0.1, 0.1}).twist.v_m_s;
  };
  CHECK_THAT(speed_at(1.0, 0.0), WithinAbs(0.08, 1e-9));
  CHECK_THAT(speed_at(1.0, 0.48), WithinAbs(0.08, 1e-9));
  CHECK_THAT(speed_at(1.23, 0.0), WithinAbs(0.08, 1e-9));
  CHECK_THAT(speed_at(1.2, 0.45), WithinAbs(0.1, 1e-9));
  CHECK_THAT(speed_at(1.0, 0.5), WithinAbs(0.09, 1e-4));
  CHECK_THAT(speed_at(1.0, 0.52), WithinAbs(0.1, 1e-9));
}

TEST_CASE("A region of the floor takes hold of each wheel by itself, or of the whole robot") {
  // To the left of the x axis, which the robot drives along.
  const std::vector<double> left{-0.2, 0.0, 0.5, 4.0, 1.0, 0.0};
  ModelSimulation whole = only({"surface_patch", "floor", left});
  ModelSimulation each = only({"surface_patch", "floor_each", left});
  for (ModelSimulation* simulation : {&whole, &each}) simulation->reset({0.0, -0.03, 0.0});
  const Twist straight = whole.step({0.1, 0.1}).twist;
  CHECK_THAT(straight.v_m_s, WithinAbs(0.1, 1e-9));
  CHECK_THAT(straight.w_rad_s, WithinAbs(0.0, 1e-9));
  const Twist dragged = each.step({0.1, 0.1}).twist;
  CHECK_THAT(dragged.v_m_s, WithinAbs(0.09, 1e-9));
  CHECK_THAT(dragged.w_rad_s, WithinAbs(0.02 / 0.258, 1e-9));
}

TEST_CASE("Play is lost on reversal; where little brakes the wheel, on starting again") {
  const auto way_m = [](ModelSimulation& simulation, double command_m_s, int periods) {
    double sum = 0.0;
    for (int k = 0; k < periods; ++k) sum += period_s * simulation.step({command_m_s, 0.0}).wheel_m_s.left;
    return sum;
  };
  const double there_m = 50 * period_s * 0.1;
  // At the largest rate a wheel of 0.1 m/s rolls on by 8 um: as good as at once.
  ModelSimulation stands_at_once = only({"backlash", "wheel", {0.004, 300.0}});
  CHECK_THAT(way_m(stands_at_once, 0.1, 50), WithinAbs(there_m, 1e-5));
  CHECK_THAT(way_m(stands_at_once, 0.0, 50), WithinAbs(0.0, 1e-5));
  CHECK_THAT(way_m(stands_at_once, 0.1, 50), WithinAbs(there_m, 1e-5));
  CHECK_THAT(way_m(stands_at_once, -0.1, 50), WithinAbs(-there_m + 0.004, 1e-5));
  // A speed that falls to 1/e in 0.1 s carries 0.1 m/s through 10 mm: more than the gap.
  ModelSimulation runs_on = only({"backlash", "wheel", {0.004, 10.0}});
  CHECK_THAT(way_m(runs_on, 0.1, 50), WithinAbs(there_m, 1e-9));
  CHECK_THAT(way_m(runs_on, 0.0, 50), WithinAbs(0.004, 1e-9));
  CHECK_THAT(way_m(runs_on, 0.1, 50), WithinAbs(there_m - 0.004, 1e-9));
}

TEST_CASE("A caster that stands nearly against the travel kicks late, and in all by its angle") {
  const auto turned_rad = [](ModelSimulation& simulation, double command_m_s, double way_m) {
    double sum = 0.0;
    for (double gone_m = 0.0; gone_m < way_m; gone_m += std::abs(command_m_s) * period_s) {
      sum += period_s * simulation.step({command_m_s, command_m_s}).twist.w_rad_s;
    }
    return sum;
  };
  const auto kicked_within = [&](double aside, double way_m) {
    ModelSimulation simulation = only({"caster_kick", "same", {0.1, 0.02, aside}});
    CHECK_THAT(turned_rad(simulation, 0.1, 0.3), WithinAbs(0.0, 1e-12));
    return turned_rad(simulation, -0.1, way_m);
  };
  CHECK_THAT(kicked_within(0.01, 0.5), WithinAbs(0.1, 1e-6));
  CHECK_THAT(kicked_within(0.3, 0.5), WithinAbs(0.1, 1e-6));
  CHECK(kicked_within(0.01, 0.03) < 0.01);
  CHECK(kicked_within(0.3, 0.03) > 0.05);
}

TEST_CASE("A caster that is turned back half-way swings no further than it had come") {
  ModelSimulation simulation = only({"caster_kick", "same", {0.1, 0.02, 0.01}});
  const auto drive = [&](double command_m_s, int periods) {
    double turned_rad = 0.0;
    for (int k = 0; k < periods; ++k) {
      turned_rad += period_s * simulation.step({command_m_s, command_m_s}).twist.w_rad_s;
    }
    return turned_rad;
  };
  drive(0.1, 100);
  const double half_rad = drive(-0.1, 51);  // 92 mm: the middle of the swing lies at ln(99) times 20 mm
  CHECK_THAT(half_rad, WithinAbs(0.05, 0.01));
  CHECK_THAT(drive(0.1, 500), WithinAbs(half_rad, 0.0015));
}

TEST_CASE("A stiff caster turns the robot on after a curve, until its fork has come round behind") {
  const double trail_m = 0.02;
  const double ahead_m = 0.12;
  ModelSimulation simulation = only({"caster_kick", "swivel", {0.01, trail_m, ahead_m}});
  const auto step = [&](WheelPair command_m_s) { return simulation.step(command_m_s).twist; };
  const WheelPair curve_m_s{0.05, 0.15};
  const double turn_rate_rad_s = 0.1 / 0.258;
  CHECK(step(curve_m_s).w_rad_s < turn_rate_rad_s);
  for (int k = 0; k < 200; ++k) step(curve_m_s);
  CHECK_THAT(step(curve_m_s).w_rad_s, WithinAbs(turn_rate_rad_s, 1e-9));

  // In the curve the fork lags behind where its pivot goes by as much as turns it as fast as the robot. Then
  // half the angle shrinks as along a tractrix; forward and sideways push show where the fork points.
  const double pivot_m_s = std::hypot(0.1, turn_rate_rad_s * ahead_m);
  const double curve_rad =
      std::atan2(turn_rate_rad_s * ahead_m, 0.1) - std::asin(turn_rate_rad_s * trail_m / pivot_m_s);
  double half_tangent = std::tan(0.5 * curve_rad);
  for (int k = 0; k < 10; ++k) {
    const Twist twist = step({0.1, 0.1});
    const double before_rad = 2.0 * std::atan(half_tangent);
    half_tangent *= std::exp(-0.1 * period_s / trail_m);
    const double fork_rad = 0.5 * (before_rad + 2.0 * std::atan(half_tangent));
    CHECK(twist.w_rad_s > 0.0);
    CHECK_THAT((0.1 - twist.v_m_s) / twist.w_rad_s * 4.0 * ahead_m / (0.258 * 0.258),
               WithinRel(std::tan(fork_rad), 1e-3));
  }
}

TEST_CASE("A motor that can be turned creeps downhill at rest, one that holds does not") {
  ModelSimulation holds = only({"floor_slope", "wheel", {0.02, 0.0}});
  CHECK_THAT(holds.step({0.0, 0.0}).wheel_m_s.left, WithinAbs(0.0, 1e-12));
  ModelSimulation creeps = only({"floor_slope", "creeping", {0.02, 0.0}});
  CHECK_THAT(creeps.step({0.0, 0.0}).wheel_m_s.left, WithinAbs(0.02, 1e-12));
}

TEST_CASE("A tyre that slides gives the robot so much acceleration and no more, until it has caught up") {
  ModelSimulation simulation = only({"acceleration_slip", "sliding", {0.5, 0.0}});
  const auto floor_m_s = [&](double command_m_s, int periods) {
    double speed_m_s = 0.0;
    for (int k = 0; k < periods; ++k) speed_m_s = simulation.step({command_m_s, command_m_s}).floor_m_s.left;
    return speed_m_s;
  };
  CHECK_THAT(floor_m_s(0.3, 5), WithinAbs(5 * period_s * 2.0, 1e-12));
  CHECK_THAT(floor_m_s(0.3, 50), WithinAbs(0.3, 1e-12));
  CHECK_THAT(floor_m_s(0.31, 1), WithinAbs(0.31, 1e-12));  // gently: it holds
  CHECK_THAT(floor_m_s(0.0, 5), WithinAbs(0.31 - 5 * period_s * 2.0, 1e-12));
}

TEST_CASE("A tyre holds up to its grip, and gives less once it slides") {
  const auto after_a_period = [](double command_m_s) {
    ModelSimulation simulation = only({"acceleration_slip", "sliding", {1.0, 5.0}});
    return simulation.step({command_m_s, command_m_s}).floor_m_s.left;
  };
  CHECK_THAT(after_a_period(4.9 * period_s), WithinAbs(4.9 * period_s, 1e-12));
  CHECK_THAT(after_a_period(5.1 * period_s), WithinAbs(1.0 * period_s, 1e-12));
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

TEST_CASE("Scrubbing tyres take the same of every turn rate, or the more the faster it is") {
  const auto turned = [](ModelSimulation simulation, double half_difference_m_s) {
    return simulation.step({0.1 - half_difference_m_s, 0.1 + half_difference_m_s}).twist.w_rad_s;
  };
  const double wheels_rad_s = 2.0 * 0.1 / 0.258;
  const ModelSimulation dry = only({"turn_scrub", "", {0.0, 0.0, 0.05}});
  CHECK_THAT(turned(dry, 0.1), WithinAbs(wheels_rad_s - 0.05, 1e-12));
  CHECK_THAT(turned(dry, -0.1), WithinAbs(-wheels_rad_s + 0.05, 1e-12));
  CHECK(turned(dry, 0.005) == 0.0);
  const ModelSimulation wet = only({"turn_scrub", "", {0.1, 0.02, 0.0}});
  CHECK_THAT(
      turned(wet, 0.1),
      WithinAbs(wheels_rad_s * (1.0 - 0.1 * wheels_rad_s - 0.02 * wheels_rad_s * wheels_rad_s), 1e-12));
}

TEST_CASE("A wheel with stiction stands again at the speed below which friction has risen") {
  const auto stands_at = [](double sticking_m_s) {
    ModelSimulation simulation = only({"stiction", "", {0.03, 0.002, 0.01, sticking_m_s}});
    double moved_at = speed_after(simulation, 0.05, 100);
    for (double command = 0.05; command > 0.0; command -= 0.0001) {
      const double speed = speed_after(simulation, command, 1);
      if (speed == 0.0) return moved_at;
      moved_at = speed;
    }
    return 0.0;
  };
  CHECK_THAT(stands_at(0.012), WithinAbs(0.012, 0.0005));
  CHECK_THAT(stands_at(0.004), WithinAbs(0.004, 0.0005));
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
    return std::ranges::count(contents.candidates, name,
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

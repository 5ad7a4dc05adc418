// What effects of floor and body do to a motion, against what can be said of it on paper.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/one_effect.hpp"

using namespace wheelwright;
using test::only;

namespace {

constexpr double period_s = test::one_effect_period_s;

}  // namespace

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

TEST_CASE("Motors take on the drag of a rug with their lag, and lose it with their lag") {
  const double lag_s = 0.2;
  ModelSimulation simulation = only({"surface_patch", "wheel", {-0.2, 0.5, 0.0, 0.5, 40.0, 0.0, lag_s}});
  const auto speed_m_s = [&](int periods) {
    double speed = 0.0;
    for (int k = 0; k < periods; ++k) speed = simulation.step({0.1, 0.1}).wheel_m_s.left;
    return speed;
  };
  const auto where_x_m = [&] { return simulation.pose().x_m; };
  CHECK(speed_m_s(1) == 0.1);
  while (where_x_m() < 0.26) speed_m_s(1);  // the edge is done
  const double on_rug_m_s = speed_m_s(1);
  CHECK(on_rug_m_s > 0.08);
  const int periods = 20;
  const double left = std::exp(-periods * period_s / lag_s);
  CHECK_THAT(speed_m_s(periods), WithinAbs(0.08 + (on_rug_m_s - 0.08) * left, 1e-12));
  while (where_x_m() < 0.76) speed_m_s(1);
  const double off_rug_m_s = speed_m_s(1);
  CHECK(off_rug_m_s < 0.1);
  CHECK_THAT(speed_m_s(periods), WithinAbs(0.1 + (off_rug_m_s - 0.1) * left, 1e-12));
}

TEST_CASE("A robot that begins on a rug has its drag from the start") {
  ModelSimulation simulation = only({"surface_patch", "wheel", {-0.2, 0.0, 0.0, 1.0, 1.0, 0.0, 0.5}});
  CHECK_THAT(simulation.step({0.1, 0.1}).wheel_m_s.left, WithinAbs(0.08, 1e-12));
  simulation.reset({5.0, 0.0, 0.0});
  CHECK(simulation.step({0.1, 0.1}).wheel_m_s.left == 0.1);
}

TEST_CASE("A mismatch is of both wheels by half, or of one that is not what the log says") {
  const auto floor_m_s = [](const std::string& variant) {
    return only({"wheel_scale_mismatch", variant, {0.04}}).step({0.1, 0.1}).floor_m_s;
  };
  const auto is = [](WheelPair speed_m_s, double left_m_s, double right_m_s) {
    CHECK_THAT(speed_m_s.left, WithinAbs(left_m_s, 1e-12));
    CHECK_THAT(speed_m_s.right, WithinAbs(right_m_s, 1e-12));
  };
  is(floor_m_s(""), 0.098, 0.102);
  is(floor_m_s("left_wheel"), 0.096, 0.1);
  is(floor_m_s("right_wheel"), 0.1, 0.104);
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

TEST_CASE("A caster that ploughs turns a slow robot farther than a fast one, a flip back the other way") {
  const auto turned_by_flips = [](const char* variant, double speed_m_s) {
    ModelSimulation simulation = only({"caster_kick", variant, {0.2, 0.02, 0.01}});
    const auto drive = [&](double command_m_s) {
      double turned_rad = 0.0;
      for (double gone_m = 0.0; gone_m < 0.5; gone_m += std::abs(command_m_s) * period_s) {
        turned_rad += period_s * simulation.step({command_m_s, command_m_s}).twist.w_rad_s;
      }
      return turned_rad;
    };
    drive(speed_m_s);
    const double back_rad = drive(-speed_m_s);
    return std::pair(back_rad, drive(speed_m_s));
  };
  const auto fast = turned_by_flips("ploughing_same", 0.2);
  const auto slow = turned_by_flips("ploughing_same", 0.1);
  CHECK(fast.first > 0.0);
  CHECK_THAT(slow.first / fast.first, WithinAbs(2.0, 0.05));
  CHECK_THAT(fast.second, WithinAbs(fast.first, 1e-3));
  const auto alternating = turned_by_flips("ploughing_alternating", 0.2);
  CHECK_THAT(alternating.first, WithinAbs(-fast.first, 1e-6));
  CHECK_THAT(alternating.second, WithinAbs(fast.second, 1e-6));
}

TEST_CASE("A scrubbing caster turns the robot to the side to which the turn before had put it") {
  const auto turned_by_flip_after = [](double turn_rate_rad_s, double lean_rad) {
    ModelSimulation simulation = only({"caster_kick", "swing", {0.1, 0.02, 0.1, lean_rad}});
    const auto drive = [&](WheelPair command_m_s, int periods) {
      double sum_rad = 0.0;
      for (int k = 0; k < periods; ++k) sum_rad += period_s * simulation.step(command_m_s).twist.w_rad_s;
      return sum_rad;
    };
    const double half_m_s = 0.5 * test::one_effect_wheel_base_m * turn_rate_rad_s;
    drive({0.1 - half_m_s, 0.1 + half_m_s}, 200);
    return drive({-0.1, -0.1}, 200);
  };
  // In a left curve the fork stands to the right of straight behind, by the angle of its pivot's way less
  // what turns it: to the front it has a half turn less that left.
  const double pivot_m_s = std::hypot(0.1, 0.05);
  const double aside_rad = std::atan2(0.05, 0.1) - std::asin(0.5 * 0.02 / pivot_m_s);
  const double swing_rad = 0.1 * (std::numbers::pi - aside_rad) / std::numbers::pi;
  CHECK_THAT(turned_by_flip_after(0.5, 0.0), WithinAbs(-turned_by_flip_after(-0.5, 0.0), 1e-9));
  CHECK_THAT(std::abs(turned_by_flip_after(0.5, 0.0)), WithinAbs(swing_rad, 0.002));
  CHECK_THAT(turned_by_flip_after(0.0, 0.1), WithinAbs(-turned_by_flip_after(0.0, -0.1), 1e-9));
  CHECK(std::abs(turned_by_flip_after(0.0, 0.1)) > 0.09);
}

TEST_CASE("A fork that is pushed ahead turns the robot to its side until it has come round") {
  constexpr double rate_rad_s = 0.3;
  constexpr double trail_m = 0.02;
  const auto turned_by_flip = [&](double speed_m_s, double lean_rad, double turn_before_m_s) {
    ModelSimulation simulation = only({"caster_kick", "ploughing", {rate_rad_s, trail_m, 0.1, lean_rad}});
    for (int k = 0; k < 200; ++k) simulation.step({0.1 - turn_before_m_s, 0.1 + turn_before_m_s});
    double turned_rad = 0.0;
    for (double gone_m = 0.0; gone_m < 0.4; gone_m += speed_m_s * period_s) {
      turned_rad += period_s * simulation.step({-speed_m_s, -speed_m_s}).twist.w_rad_s;
    }
    return turned_rad;
  };
  // It begins at twice its lean from where it points ahead, and goes along a tractrix until it stands across.
  constexpr double lean_rad = 0.02;
  const double begin_rad = 2.0 * lean_rad;
  const double area_m =
      trail_m * (std::cos(lean_rad) * (1.0 - std::sin(begin_rad)) +
                 std::sin(lean_rad) * (std::log(std::tan(0.5 * begin_rad)) + std::cos(begin_rad)));
  CHECK_THAT(turned_by_flip(0.05, lean_rad, 0.0), WithinRel(rate_rad_s * area_m / 0.05, 0.01));
  CHECK_THAT(turned_by_flip(0.1, lean_rad, 0.0), WithinRel(rate_rad_s * area_m / 0.1, 0.01));
  const EffectInfo* info = find_effect("caster_kick");
  const auto only_kicks = [&](double rate, double largest_command_m_s) {
    const std::vector<double> parameters{rate, trail_m, 0.1, 0.0};
    return info->in_character({parameters, variant_index(*info, "ploughing")}, largest_command_m_s);
  };
  CHECK(only_kicks(2.0, 0.1));  // 0.4 rad in all
  CHECK_FALSE(only_kicks(3.0, 0.1));
  const double after_left_rad = turned_by_flip(0.1, 0.0, 0.02);
  CHECK(std::abs(after_left_rad) > 0.01);
  CHECK_THAT(turned_by_flip(0.1, 0.0, -0.02), WithinAbs(-after_left_rad, 1e-9));
}

TEST_CASE("A caster turns the robot on after a curve, until its fork has come round behind") {
  const double trail_m = 0.02;
  const double ahead_m = 0.12;
  // So little friction that the robot's way is not changed by it.
  ModelSimulation simulation = only({"caster_kick", "swivel", {1e-7, trail_m, ahead_m, 0.0, 0.5}});
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

TEST_CASE("A caster whose friction nothing overcomes keeps its fork where it stands") {
  const double ahead_m = 0.12;
  ModelSimulation simulation = only({"caster_kick", "swivel", {0.3, 0.02, ahead_m, 0.0, 0.03}});
  for (int k = 0; k < 100; ++k) simulation.step({0.1, 0.1});
  // Into a curve: a wheel that rolls straight on at the nose lets the robot hardly turn.
  double turned_rad = 0.0;
  for (int k = 0; k < 10; ++k) turned_rad += period_s * simulation.step({0.08, 0.12}).twist.w_rad_s;
  CHECK(std::abs(turned_rad) < 0.02 * 10 * period_s * 0.04 / 0.258);
}

TEST_CASE("Wheels give way to a stiff caster with a lag") {
  const auto taken_rad_s = [](double lag_s, int periods) {
    ModelSimulation simulation = only({"caster_kick", "swivel", {0.001, 0.02, 0.12, lag_s, 0.03}});
    double w_rad_s = 0.0;
    for (int k = 0; k < periods; ++k) w_rad_s = simulation.step({-0.05, 0.05}).twist.w_rad_s;
    return 0.1 / 0.258 - w_rad_s;
  };
  const double at_once_rad_s = taken_rad_s(0.0, 1);
  CHECK(at_once_rad_s > 0.0);
  CHECK_THAT(taken_rad_s(period_s, 1), WithinRel(0.5 * at_once_rad_s, 0.02));
  CHECK_THAT(taken_rad_s(period_s, 2), WithinRel(0.75 * taken_rad_s(0.0, 2), 0.05));
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

TEST_CASE(
    "Tyres that slide turn the robot as its mass and inertia let them, and one of them holds where it can") {
  constexpr double limit_m_s2 = 2.0;
  constexpr double turning = 1.3;
  const auto floor_m_s = [](const WheelPair& command_m_s, int periods) {
    ModelSimulation simulation = only({"acceleration_slip", "tied", {1.0 / limit_m_s2, turning}});
    WheelPair speed_m_s;
    for (int k = 0; k < periods; ++k) speed_m_s = simulation.step(command_m_s).floor_m_s;
    return speed_m_s;
  };
  // Straight on, both push by half of the limit times the mass each.
  CHECK_THAT(floor_m_s({0.3, 0.3}, 5).left, WithinAbs(5 * period_s * limit_m_s2, 1e-12));
  CHECK_THAT(floor_m_s({0.3, 0.3}, 50).left, WithinAbs(0.3, 1e-12));
  // On the spot, the same forces turn it: I dw/dt = F b, and a side goes by b/2 times the turn rate.
  CHECK_THAT(floor_m_s({-0.3, 0.3}, 5).right, WithinAbs(5 * period_s * turning * limit_m_s2, 1e-12));
  // One side alone: the standing wheel's tyre holds the pivot.
  const WheelPair about_the_right = floor_m_s({0.3, 0.0}, 5);
  CHECK_THAT(about_the_right.right, WithinAbs(0.0, 1e-12));
  CHECK_THAT(about_the_right.left,
             WithinAbs(5 * period_s * 2.0 * turning / (1.0 + turning) * limit_m_s2, 1e-12));
  // Gently, nothing slides.
  CHECK_THAT(floor_m_s({0.01, 0.02}, 1).right, WithinAbs(0.02, 1e-12));
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

TEST_CASE("Tyres that creep take a share of a slow turn, and no more than their friction of a fast one") {
  constexpr double dry_rad_s = 0.05;
  constexpr double sliding_rad_s = 0.1;
  constexpr double lag_s = 0.06;
  const auto lost_rad_s = [&](double rate_rad_s, int periods) {
    ModelSimulation simulation = only({"turn_scrub", "creep", {dry_rad_s, sliding_rad_s, lag_s}});
    const WheelPair wheels = wheels_of_twist({0.1, rate_rad_s}, 0.258);
    double left_rad_s = rate_rad_s;
    for (int k = 0; k < periods; ++k) left_rad_s = simulation.step(wheels).twist.w_rad_s;
    return rate_rad_s - left_rad_s;
  };
  CHECK_THAT(lost_rad_s(2.0, 200), WithinAbs(dry_rad_s, 1e-9));
  CHECK_THAT(lost_rad_s(-2.0, 200), WithinAbs(-dry_rad_s, 1e-9));
  CHECK_THAT(lost_rad_s(2.0, 4),
             WithinAbs(dry_rad_s * (1.0 - std::pow(lag_s / (period_s + lag_s), 4)), 1e-9));
  // Of the rate that is left: friction rises with it by dry / sliding.
  const double slow_rad_s = 1e-4;
  const double left_rad_s = slow_rad_s - lost_rad_s(slow_rad_s, 400);
  CHECK_THAT(lost_rad_s(slow_rad_s, 400), WithinRel(dry_rad_s / sliding_rad_s * left_rad_s, 1e-4));
}

TEST_CASE("A load of turning sees the turn on the floor, which wheels of another size do not count") {
  const EffectSetting unequal{"wheel_scale_mismatch", "", {0.04}};
  const EffectSetting scrub{"turn_scrub", "at_wheels", {0.0, 0.0, 0.05}};
  const auto moved = [](const std::vector<EffectSetting>& effects, const WheelPair& command_m_s) {
    return only(effects).step(command_m_s);
  };
  const WheelPair straight{0.2 / 0.98, 0.2 / 1.02};  // on the floor
  const ModelSimulation::Motion unhindered = moved({scrub, unequal}, straight);
  CHECK_THAT(unhindered.twist.w_rad_s, WithinAbs(0.0, 1e-12));
  CHECK_THAT(unhindered.wheel_m_s.left, WithinAbs(straight.left, 1e-12));
  const WheelPair even{0.2, 0.2};  // counted, and a bend to the left on the floor
  const double bend_rad_s = moved({unequal}, even).twist.w_rad_s;
  const ModelSimulation::Motion hindered = moved({scrub, unequal}, even);
  CHECK(bend_rad_s > 0.0);
  CHECK(hindered.twist.w_rad_s == 0.0);  // less than the tyres hold
  CHECK(hindered.wheel_m_s.left > hindered.wheel_m_s.right);
  const EffectSetting larger{"distance_scale", "", {0.1}};
  const WheelPair turning{0.1, 0.2};
  const double freely_rad_s = moved({larger}, turning).twist.w_rad_s;
  CHECK_THAT(moved({scrub, larger}, turning).twist.w_rad_s, WithinAbs(freely_rad_s - 0.05, 1e-12));
}

TEST_CASE("A scale of distance whose turns are as counted moves the robot further, and turns it as before") {
  constexpr double change = 0.1;
  const WheelPair command_m_s{0.1, 0.25};
  const Twist counted = only(std::vector<EffectSetting>{}).step(command_m_s).twist;
  const Twist moved = only({"distance_scale", "turns_as_counted", {change}}).step(command_m_s).twist;
  CHECK_THAT(moved.v_m_s, WithinRel((1.0 + change) * counted.v_m_s, 1e-12));
  CHECK_THAT(moved.w_rad_s, WithinRel(counted.w_rad_s, 1e-12));
  const EffectSetting scrub{"turn_scrub", "at_wheels", {0.0, 0.0, 0.05}};
  const EffectSetting scale{"distance_scale", "turns_as_counted", {change}};
  CHECK_THAT(only({scrub, scale}).step(command_m_s).twist.w_rad_s, WithinAbs(counted.w_rad_s - 0.05, 1e-12));
}

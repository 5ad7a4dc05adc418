// Driving about a room.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/sixth_plant/dice.hpp"
#include "tests/benchmark/sixth_plant/programmes.hpp"

namespace plants::sixth {

namespace {

constexpr double pi = std::numbers::pi;

void come_home(Hand& hand) {
  const double off_rad = hand.homeward_rad();
  if (hand.faces_outward() && hand.random.chance(0.5))
    return hand.go_curved(-1, {0.3, 1}, {-0.5, 0.5}, {1, 2.5});
  const double turn_rad_s = std::copysign(hand.random.uniform(0.7, 2.), off_rad);
  const double forward_m_s = hand.random.chance(0.5) ? hand.drawn_m_s({0.2, 0.4}) : 0;
  hand.go(forward_m_s, turn_rad_s, std::abs(off_rad) / std::abs(turn_rad_s));
  hand.go_curved(1, {0.4, 1}, {-0.2, 0.2}, {1, 2.5});
}

void move_at_will(Hand& hand) {
  const double choice = unit(hand.random);
  if (choice < 0.40)
    hand.go_curved(1, {0.15, 1}, {-1.2, 1.2}, {0.6, 2.5});
  else if (choice < 0.52)
    hand.go_straight({0.5, 1}, {0.8, 2});
  else if (choice < 0.68)
    hand.go_curved(-1, {0.15, 0.9}, {-1, 1}, {0.6, 2});
  else if (choice < 0.82)
    hand.spin({0.5, 3}, {0.4, 1.4});
  else if (choice < 0.90)
    hand.rest({0.4, 1.3});
  else
    hand.go_curved(1, {0.05, 0.25}, {-0.4, 0.4}, {0.8, 2});
}

void back_and_forth(Hand& hand) {
  const double speed_m_s = hand.drawn_m_s({0.3, 0.8});
  const double way_m = hand.random.uniform(0.2, 0.5);
  hand.go(-speed_m_s, 0, way_m / speed_m_s);
  hand.go(0, 0, 0.3);
  hand.go(speed_m_s, 0, way_m / speed_m_s);
}

// A circle or half of one.
void drive_lap(Hand& hand, double side) {
  constexpr double fastest_rad_s = 3;
  const Robot& robot = hand.robot();
  double speed_m_s = hand.drawn_m_s({0.35, 0.85});
  const double radius_m = hand.random.uniform(0.14, 0.45);
  if (speed_m_s / radius_m > fastest_rad_s) speed_m_s = fastest_rad_s * radius_m;
  speed_m_s = std::min(speed_m_s, robot.top_m_s / (1 + robot.wheel_base_m / 2 / radius_m));
  const double turn_rad_s = speed_m_s / radius_m;
  const bool backward = hand.random.chance(0.25);
  const double lap_s = 2 * pi / turn_rad_s / robot.gain * (hand.random.chance(0.3) ? 0.5 : 1);
  hand.go(backward ? -speed_m_s : speed_m_s, side * turn_rad_s, lap_s);
}

void approach(Hand& hand, double until_s) {
  constexpr double patience_s = 9;
  constexpr double near_m = 0.06;
  const double goal_x_m = hand.random.uniform(-1, 1);
  const double goal_y_m = hand.random.uniform(-1, 1);
  const bool backward = hand.random.chance(0.3);
  const double top_m_s = hand.drawn_m_s({0.35, 1});
  const int most_rows = static_cast<int>(patience_s / hand.robot().period_s);
  for (int rows = 0; rows < most_rows && hand.now_s() < until_s; ++rows) {
    const Pose& place = hand.place();
    const double x_m = goal_x_m - place.x_m;
    const double y_m = goal_y_m - place.y_m;
    const double distance_m = std::hypot(x_m, y_m);
    if (distance_m < near_m) break;
    const double off_rad = wrapped_rad(std::atan2(y_m, x_m) - place.heading_rad - (backward ? pi : 0));
    const double turn_rad_s = std::clamp(2.2 * off_rad, -2.8, 2.8);
    const double speed_m_s =
        std::abs(off_rad) > 0.8 ? 0 : std::min(top_m_s, 1.1 * distance_m + 0.03) * std::cos(off_rad);
    hand.row(backward ? -speed_m_s : speed_m_s, turn_rad_s);
  }
}

}  // namespace

void drive_teleoperation(Hand& hand, double duration_s) {
  constexpr double room_m = 1.2;
  hand.ramp_s = hand.random.uniform(0.1, 0.5);
  while (hand.now_s() < duration_s - 1.5) {
    if (hand.away_m() > room_m && hand.random.chance(0.7))
      come_home(hand);
    else
      move_at_will(hand);
  }
}

void drive_squares(Hand& hand, double duration_s) {
  hand.ramp_s = hand.random.uniform(0.05, 0.25);
  const double edge_m = hand.random.uniform(0.5, 1.0);
  double side = hand.random.sign();
  for (int edge = 1; hand.now_s() < duration_s - 3; ++edge) {
    const double speed_m_s = hand.drawn_m_s({0.4, 1});
    hand.go(speed_m_s, 0, edge_m / speed_m_s);
    if (hand.random.chance(0.5)) hand.rest({0.2, 0.8});
    hand.turn_by(side * pi / 2, hand.random.uniform(0.8, 3));
    if (hand.random.chance(0.3)) hand.rest({0.2, 0.9});
    if (edge % 4 != 0) continue;
    if (hand.random.chance(0.6)) side = -side;
    if (hand.random.chance(0.5)) back_and_forth(hand);
  }
}

void drive_eights(Hand& hand, double duration_s) {
  hand.ramp_s = hand.random.uniform(0.1, 0.4);
  for (double side = hand.random.sign(); hand.now_s() < duration_s - 2; side = -side) {
    drive_lap(hand, side);
    if (hand.random.chance(0.2)) hand.rest({0.3, 1});
    if (!hand.random.chance(0.25)) continue;
    const double speed_m_s = hand.drawn_m_s({0.3, 1});
    const double way = hand.away_m() > 1 && hand.faces_outward() ? -1 : 1;
    hand.go(way * speed_m_s, 0, hand.random.uniform(0.4, 1.2));
  }
}

void drive_goals(Hand& hand, double duration_s) {
  hand.ramp_s = hand.random.uniform(0.05, 0.3);
  while (hand.now_s() < duration_s - 6) {
    approach(hand, duration_s - 2);
    if (hand.random.chance(0.6)) hand.rest({0.3, 1.2});
  }
}

}  // namespace plants::sixth

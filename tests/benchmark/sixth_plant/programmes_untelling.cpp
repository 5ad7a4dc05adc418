// Driving that leaves out what an effect needs in order to show.
#include <cmath>

#include "tests/benchmark/sixth_plant/dice.hpp"
#include "tests/benchmark/sixth_plant/programmes.hpp"

namespace plants::sixth {

namespace {

void crawl(Hand& hand) {
  const double seconds = hand.random.uniform(1, 3);
  const double turn_rad_s = hand.random.uniform(-0.3, 0.3);
  const double speed_m_s = hand.drawn_m_s({0.1, 0.25});
  hand.go(speed_m_s * (hand.random.chance(0.7) ? 1 : -1), turn_rad_s, seconds);
}

void turn_slowly(Hand& hand) {
  const Robot& robot = hand.robot();
  const double seconds = hand.random.uniform(0.5, 1.5);
  const double share = hand.random.signed_uniform(0.2, 0.35);
  hand.go(0, share * robot.top_m_s * 2 / robot.wheel_base_m * 0.6, seconds);
}

}  // namespace

void drive_straight(Hand& hand, double duration_s) {
  hand.ramp_s = hand.random.uniform(0, 0.2);
  for (double way = hand.random.sign(); hand.now_s() < duration_s - 4; way = -way) {
    const double speed_m_s = hand.drawn_m_s({0.2, 1});
    const double way_m = hand.random.uniform(0.3, 0.9);
    hand.go(way * speed_m_s, 0, way_m / speed_m_s);
    if (hand.random.chance(0.6)) hand.rest({0.3, 1});
  }
}

void drive_forward_only(Hand& hand, double duration_s) {
  constexpr double room_m = 0.8;
  const Robot& robot = hand.robot();
  hand.ramp_s = 2.5;
  while (hand.now_s() < duration_s) {
    const double speed_m_s = hand.drawn_m_s({0.45, 0.8});
    double turn_rad_s = hand.random.uniform(-1, 1) * 0.25 * robot.top_m_s / robot.wheel_base_m;
    if (hand.away_m() > room_m)
      turn_rad_s = std::copysign(0.3 * robot.top_m_s / robot.wheel_base_m, hand.homeward_rad());
    hand.go(speed_m_s, turn_rad_s, hand.random.uniform(1, 3));
  }
}

void drive_slow_only(Hand& hand, double duration_s) {
  hand.ramp_s = 0.2;
  while (hand.now_s() < duration_s - 2) {
    const double choice = unit(hand.random);
    if (choice < 0.5)
      crawl(hand);
    else if (choice < 0.8)
      turn_slowly(hand);
    else
      hand.rest({0.3, 1});
  }
}

}  // namespace plants::sixth

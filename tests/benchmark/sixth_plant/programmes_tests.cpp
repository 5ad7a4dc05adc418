// Driving as one does to try a motor.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/sixth_plant/dice.hpp"
#include "tests/benchmark/sixth_plant/programmes.hpp"

namespace plants::sixth {

namespace {

void step_there_and_back(Hand& hand, double speed_m_s, double seconds) {
  hand.go(speed_m_s, 0, seconds);
  hand.rest({0.3, 1.4});
  hand.go(-speed_m_s, 0, seconds);
  hand.rest({0.3, 1.4});
}

void step_through_zero(Hand& hand, double speed_m_s, double seconds) {
  hand.go(speed_m_s, 0, seconds);
  hand.go(-speed_m_s, 0, seconds);
  hand.rest({0.3, 1});
}

void step_on_the_spot(Hand& hand, double speed_m_s) {
  const double turn_rad_s = std::min(3.5, 2 * speed_m_s / hand.robot().wheel_base_m) * hand.random.sign();
  hand.go(0, turn_rad_s, hand.random.uniform(0.5, 1.2));
  if (hand.random.chance(0.5)) hand.go(0, -turn_rad_s, hand.random.uniform(0.5, 1.2));
  hand.rest({0.3, 1.2});
}

// Up and down a staircase, and all the way back.
void step_by_step(Hand& hand, double speed_m_s) {
  const double other_m_s = hand.drawn_m_s({0.5, 1});
  hand.go(speed_m_s, 0, 0.8);
  hand.go(other_m_s, 0, 0.8);
  hand.go(speed_m_s * 0.5, 0, 0.8);
  hand.go(0, 0, 0.6);
  const double way_m = speed_m_s * 0.8 + other_m_s * 0.8 + speed_m_s * 0.4;
  hand.go(-other_m_s, 0, way_m / other_m_s);
  hand.rest({0.3, 1.});
}

// Speed and turn rate rise and fall together.
void creep_in_a_triangle(Hand& hand) {
  constexpr double pi = std::numbers::pi;
  const double size_m_s = hand.drawn_m_s({0.15, 0.45});
  const double period_s = hand.random.uniform(4, 9);
  const double phase_rad = hand.random.chance(0.5) ? 0 : pi;
  const int rows = static_cast<int>(period_s / hand.robot().period_s);
  const double turn_rad_s = hand.random.uniform(-1, 1) * 0.6;
  for (int row = 0; row < rows; ++row) {
    const double triangle = 2 / pi * std::asin(std::sin(2 * pi * row / rows + phase_rad));
    hand.row(size_m_s * triangle, turn_rad_s * triangle);
  }
}

void creep_there_and_back(Hand& hand) {
  double speed_m_s = hand.drawn_m_s({0.03, 0.3});
  speed_m_s *= hand.random.sign();
  const double seconds = hand.random.uniform(1, 2.5);
  for (const double way : {1.0, -1.0}) {
    hand.go(way * speed_m_s, hand.random.uniform(-0.3, 0.3), seconds);
    if (hand.random.chance(0.6)) hand.rest({0.3, 1});
  }
}

void hurry_there_and_back(Hand& hand) {
  double speed_m_s = hand.drawn_m_s({0.3, 0.8});
  speed_m_s *= hand.random.sign();
  hand.go(speed_m_s, 0, hand.random.uniform(0.6, 1.4));
  hand.go(-speed_m_s, 0, hand.random.uniform(0.6, 1.4));
  hand.go(0, 0, 0.5);
}

}  // namespace

void drive_steps(Hand& hand, double duration_s) {
  hand.ramp_s = 0;
  while (hand.now_s() < duration_s - 5) {
    const double speed_m_s = hand.drawn_m_s({0.1, 1});
    const double seconds = hand.random.uniform(0.8, 2.2);
    const double choice = unit(hand.random);
    if (choice < 0.45)
      step_there_and_back(hand, speed_m_s, seconds);
    else if (choice < 0.65)
      step_through_zero(hand, speed_m_s, seconds);
    else if (choice < 0.85)
      step_on_the_spot(hand, speed_m_s);
    else
      step_by_step(hand, speed_m_s);
  }
}

void drive_creep(Hand& hand, double duration_s) {
  hand.ramp_s = 0;
  while (hand.now_s() < duration_s - 6) {
    const double choice = unit(hand.random);
    if (choice < 0.4) {
      creep_in_a_triangle(hand);
    } else if (choice < 0.7) {
      creep_there_and_back(hand);
    } else if (choice < 0.85) {
      hurry_there_and_back(hand);
    } else {
      hand.spin({0.15, 1.2}, {1, 2});
      hand.spin({0.15, 1.2}, {1, 2});
    }
  }
}

}  // namespace plants::sixth

#include "model/gap/next_experiment/manoeuvres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace wheelwright::gap {
namespace {

constexpr double rest_s = 0.5;
constexpr double part_s = 0.15;      // of a change too hard to be made at once
constexpr double used_radius = 0.8;  // share of the free floor that a straight line may take
constexpr double spin_speed = 0.6;   // of the largest, for wheels that turn against each other

// Lays commands one after the other, no change harder than the limit.
class Program {
 public:
  Program(double period_s, double largest_change_m_s, std::string name)
      : period_s_(period_s), largest_change_m_s_(largest_change_m_s), made_{std::move(name), {}} {
    rest(rest_s);
  }
  void hold(double left, double right, double seconds) {
    const WheelPair from = made_.commands_m_s.empty() ? WheelPair{} : made_.commands_m_s.back();
    const double change = std::max(std::abs(left - from.left), std::abs(right - from.right));
    const double parts = std::ceil(change / largest_change_m_s_ - 1e-9);
    for (double part = 1.0; part < parts; ++part) {
      const double share = part / parts;
      add({from.left + share * (left - from.left), from.right + share * (right - from.right)}, part_s);
    }
    add({left, right}, seconds);
  }
  void straight(double speed, double seconds) { hold(speed, speed, seconds); }
  void rest(double seconds) { hold(0.0, 0.0, seconds); }
  // Both wheels from one speed to another at a constant rate.
  void ramp(double from, double to, double seconds) {
    const auto periods = static_cast<std::size_t>(std::lround(seconds / period_s_));
    for (std::size_t k = 0; k < periods; ++k) {
      const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(periods);
      straight(from + share * (to - from), period_s_);
    }
  }
  double seconds() const { return period_s_ * static_cast<double>(made_.commands_m_s.size()); }
  Manoeuvre done() {
    rest(rest_s);
    return std::move(made_);
  }

 private:
  void add(const WheelPair& command, double seconds) {
    const auto periods = static_cast<std::size_t>(std::lround(seconds / period_s_));
    made_.commands_m_s.insert(made_.commands_m_s.end(), periods, command);
  }

  double period_s_;
  double largest_change_m_s_;
  Manoeuvre made_;
};

struct Floor {
  double speed = 0.0;
  double largest_change_m_s = 0.0;
  double radius_m = 0.0;
  double wheel_base_m = 0.0;
  double period_s = 0.0;

  Program program(const std::string& name) const { return {period_s, largest_change_m_s, name}; }
  // As long as wanted, and no further than the floor goes.
  double seconds(double at_speed, double wanted_s) const {
    return std::min(wanted_s, used_radius * radius_m / at_speed);
  }
  // Wheels on a circle of half the free radius, so that it passes through the start.
  WheelPair circle(double middle_speed) const {
    const double lean = wheel_base_m / (0.8 * radius_m);
    return {middle_speed * (1.0 - lean), middle_speed * (1.0 + lean)};
  }
  double circle_speed() const { return speed / (1.0 + wheel_base_m / (0.8 * radius_m)); }
};

Manoeuvre slow_triangle(const Floor& floor) {
  Program program = floor.program("slow triangle through zero");
  const double peak = std::min(0.5 * floor.speed, 0.1);
  const double quarter_s = std::min(3.0, used_radius * floor.radius_m / peak);
  for (int turn = 0; turn < 2; ++turn) {
    program.ramp(0.0, peak, quarter_s);
    program.ramp(peak, -peak, 2.0 * quarter_s);
    program.ramp(-peak, 0.0, quarter_s);
  }
  return program.done();
}

Manoeuvre steps(const Floor& floor) {
  Program program = floor.program("steps of several sizes, forward and back");
  for (const double share : {0.15, 0.3, 0.5, 0.75, 1.0}) {
    const double hold_s = floor.seconds(share * floor.speed, 1.5);
    program.straight(share * floor.speed, hold_s);
    program.rest(0.6);
    program.straight(-share * floor.speed, hold_s);
    program.rest(0.6);
  }
  return program.done();
}

Manoeuvre to_and_fro(const Floor& floor) {
  Program program = floor.program("to and fro along a line at two speeds");
  for (const double share : {1.0, 0.5}) {
    const double hold_s = floor.seconds(share * floor.speed, 2.0);
    for (int turn = 0; turn < 3; ++turn) {
      program.straight(share * floor.speed, hold_s);
      program.straight(-share * floor.speed, hold_s);
    }
  }
  return program.done();
}

Manoeuvre coast_downs(const Floor& floor) {
  Program program = floor.program("coast-downs: slow start, sudden stop, and the other way round");
  const double ramp_s = floor.seconds(0.5 * floor.speed, 1.5);
  for (const double direction : {1.0, -1.0, 1.0, -1.0}) {
    program.ramp(0.0, direction * floor.speed, ramp_s);
    program.rest(0.8);
    program.straight(direction * floor.speed, 0.25);
    program.ramp(direction * floor.speed, 0.0, 0.5 * ramp_s);
    program.rest(0.4);
  }
  return program.done();
}

Manoeuvre wiggles(const Floor& floor) {
  Program program = floor.program("reversals of different length");
  for (const double share : {0.3, 0.8}) {
    for (const double hold_s : {0.2, 0.4, 0.8, 1.6}) {
      const double held_s = floor.seconds(share * floor.speed, hold_s);
      for (int turn = 0; turn < 2; ++turn) {
        program.straight(share * floor.speed, held_s);
        program.straight(-share * floor.speed, held_s);
      }
    }
  }
  return program.done();
}

Manoeuvre spins(const Floor& floor) {
  Program program = floor.program("spins on the spot at several rates, both ways");
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const double wheel = share * spin_speed * floor.speed;
    program.hold(-wheel, wheel, 2.0);
    program.rest(0.4);
    program.hold(wheel, -wheel, 2.0);
    program.rest(0.4);
  }
  return program.done();
}

Manoeuvre bends(const Floor& floor) {
  Program program = floor.program("bends of several radii at one speed, forward and back");
  const double middle = 0.6 * floor.speed;
  const double hold_s = floor.seconds(middle, 2.0);
  for (const double lean : {0.2, 0.4, 0.6}) {
    for (const double side : {1.0, -1.0}) {
      const double left = middle * (1.0 - side * lean);
      const double right = middle * (1.0 + side * lean);
      program.hold(left, right, hold_s);
      program.hold(-left, -right, hold_s);
    }
  }
  return program.done();
}

// Each wheel flips between two speeds by a fixed pseudo-random sequence: all frequencies at one amplitude.
Manoeuvre random_binary(const Floor& floor) {
  Program program = floor.program("fast random binary commands");
  std::mt19937_64 random(1);
  const double size = 0.6 * floor.speed;
  double along = size;
  while (program.seconds() < 20.0) {
    // Forward and back in pairs, so that it stays where it is.
    const double hold_s = 0.1 + 0.05 * static_cast<double>(random() % 7);
    const bool bent = random() % 2 == 0;
    for (int half = 0; half < 2; ++half) {
      program.hold(along, bent ? 0.4 * along : along, hold_s);
      along = -along;
    }
    if (random() % 2 == 0) along = -along;
  }
  return program.done();
}

Manoeuvre four_headings(const Floor& floor) {
  Program program = floor.program("to and fro at four headings");
  const double wheel = 0.5 * floor.speed;
  const double quarter_s = 0.25 * std::numbers::pi * floor.wheel_base_m / wheel;
  const double hold_s = floor.seconds(0.8 * floor.speed, 2.0);
  for (int heading = 0; heading < 4; ++heading) {
    program.straight(0.8 * floor.speed, hold_s);
    program.rest(0.4);
    program.straight(-0.8 * floor.speed, hold_s);
    program.rest(0.4);
    program.hold(-wheel, wheel, quarter_s);
    program.rest(0.4);
  }
  return program.done();
}

Manoeuvre two_speeds(const Floor& floor) {
  Program program = floor.program("hard changes between two speeds on a circle");
  const WheelPair fast = floor.circle(floor.circle_speed());
  for (int turn = 0; turn < 8; ++turn) {
    program.hold(fast.left, fast.right, 1.2);
    program.hold(0.3 * fast.left, 0.3 * fast.right, 1.2);
  }
  return program.done();
}

Manoeuvre a_minute(const Floor& floor) {
  Program program = floor.program("a minute on a circle at constant speed");
  const WheelPair wheels = floor.circle(0.7 * floor.circle_speed());
  program.hold(wheels.left, wheels.right, 60.0);
  return program.done();
}

}  // namespace

std::vector<Manoeuvre> safe_manoeuvres(const ManoeuvreLimits& limits, double wheel_base_m, double period_s) {
  const Floor floor{limits.largest_speed_m_s, limits.largest_change_m_s, limits.radius_m, wheel_base_m,
                    period_s};
  constexpr std::array menu{slow_triangle, steps,         to_and_fro,    coast_downs, wiggles, spins,
                            bends,         random_binary, four_headings, two_speeds,  a_minute};
  std::vector<Manoeuvre> made;
  made.reserve(menu.size());
  for (const auto& make : menu) made.push_back(make(floor));
  return made;
}

}  // namespace wheelwright::gap

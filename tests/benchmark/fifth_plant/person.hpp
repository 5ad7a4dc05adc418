#pragma once

#include <memory>
#include <string>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::fifth {

// What people do with the robot.
enum class Programme {
  teleoperation,  // by joystick, in a room
  docking,        // to a charger and out again
  laps,           // forward only, in both directions
  patrol,         // from place to place, with stops
  slow,           // creeping, through zero speed
  corridor,       // straight to and fro
  straight_on,    // straight forward, with stops
  turning,        // about places, tight and wide
  errands,        // hard starts and stops
};

std::string name_of(Programme programme);

// How a person drives.
struct Style {
  double wheel_base_m = 0.4;
  double top_m_s = 0.6;  // of a wheel
  double turn_rad_s = 1.2;
  double hurry_m_s2 = 0.6;  // how fast the joystick is moved
};

struct Twist {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
};

// What the person wants to happen at a moment.
class Intent {
 public:
  Intent() = default;
  Intent(const Intent&) = delete;
  Intent& operator=(const Intent&) = delete;
  virtual ~Intent() = default;
  virtual Twist want(double time_s, const Pose& seen) = 0;
};

std::unique_ptr<Intent> make_intent(Programme programme, const Style& style, const Random& random);

// Moves the joystick towards what is intended; rests in the beginning and at the end.
class Person {
 public:
  Person(Programme programme, const Style& style, double period_s, double duration_s, const Random& random);

  // Wheel speeds for the row, in whole millimetres a second.
  PerWheel<double> command(double time_s, const Pose& seen);

 private:
  Style style_;
  double period_s_;
  double duration_s_;
  std::unique_ptr<Intent> intent_;
  Twist stick_;
};

}  // namespace plants::fifth

#pragma once

#include <string>

#include "tests/benchmark/sixth_plant/hand.hpp"

namespace plants::sixth {

// How a robot is driven.
enum class Programme {
  teleoperation,
  squares,
  eights,
  steps,
  creep,
  goals,
  straight,
  forward_only,
  slow_only,
};

std::string name_of(Programme programme);

void drive_teleoperation(Hand& hand, double duration_s);
void drive_squares(Hand& hand, double duration_s);
void drive_eights(Hand& hand, double duration_s);
void drive_goals(Hand& hand, double duration_s);

void drive_steps(Hand& hand, double duration_s);
void drive_creep(Hand& hand, double duration_s);

// Drives that leave something out, so that they cannot show it.
void drive_straight(Hand& hand, double duration_s);
void drive_forward_only(Hand& hand, double duration_s);
void drive_slow_only(Hand& hand, double duration_s);

// About so long, with rest at the beginning and, but for forward_only, at the end.
void drive(Hand& hand, Programme programme, double duration_s);

}  // namespace plants::sixth

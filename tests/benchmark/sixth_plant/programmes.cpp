#include "tests/benchmark/sixth_plant/programmes.hpp"

namespace plants::sixth {

namespace {

void drive_moving(Hand& hand, Programme programme, double duration_s) {
  switch (programme) {
    case Programme::teleoperation:
      return drive_teleoperation(hand, duration_s);
    case Programme::squares:
      return drive_squares(hand, duration_s);
    case Programme::eights:
      return drive_eights(hand, duration_s);
    case Programme::steps:
      return drive_steps(hand, duration_s);
    case Programme::creep:
      return drive_creep(hand, duration_s);
    case Programme::goals:
      return drive_goals(hand, duration_s);
    case Programme::straight:
      return drive_straight(hand, duration_s);
    case Programme::forward_only:
      return drive_forward_only(hand, duration_s);
    case Programme::slow_only:
      return drive_slow_only(hand, duration_s);
  }
}

}  // namespace

std::string name_of(Programme programme) {
  switch (programme) {
    case Programme::teleoperation:
      return "teleoperation";
    case Programme::squares:
      return "squares";
    case Programme::eights:
      return "eights";
    case Programme::steps:
      return "steps";
    case Programme::creep:
      return "creep";
    case Programme::goals:
      return "goals";
    case Programme::straight:
      return "straight";
    case Programme::forward_only:
      return "forward_only";
    case Programme::slow_only:
      break;
  }
  return "slow_only";
}

void drive(Hand& hand, Programme programme, double duration_s) {
  hand.rest({0.6, 1.4});
  drive_moving(hand, programme, duration_s);
  // Coming to rest would let the teeth change sides.
  if (programme == Programme::forward_only) return;
  hand.ramp_s = 0.1;
  hand.rest({0.6, 1.3});
}

}  // namespace plants::sixth

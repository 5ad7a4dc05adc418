// Which sign the motor currents have while a wheel goes backward: that of the speed, or none.
//
// The Open Interface calls the currents of packets 54 and 55 signed in their heading and unsigned in their
// text. The first quarter of a second of driving backward shows which it is.
#pragma once

#include <cmath>

namespace wheelwright {

class CurrentSign {
 public:
  // A reading while the wheel goes at this speed, by the model.
  void take(double speed_m_s, double current_a) {
    if (!(speed_m_s < 0.0) || std::abs(current_a) < smallest_a || is_known()) return;
    signed_votes_ += current_a < 0.0 ? 1 : -1;
  }

  // Whether it is known what this reading means.
  bool tells(double speed_m_s, double current_a) const {
    return is_known() || speed_m_s > 0.0 || std::abs(current_a) < smallest_a;
  }

  // With the sign of the speed for a motor that drives.
  double along_wheel_a(double speed_m_s, double current_a) const {
    return signed_votes_ < 0 && speed_m_s < 0.0 ? -current_a : current_a;
  }

 private:
  bool is_known() const { return std::abs(signed_votes_) >= enough_votes; }

  static constexpr double smallest_a = 0.02;
  static constexpr int enough_votes = 14;  // periods: braking has the other sign for some of them

  int signed_votes_ = 0;
};

}  // namespace wheelwright

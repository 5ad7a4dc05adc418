#pragma once

namespace plants::third {

enum class Play {
  none,
  operator_of_play,  // the wheel is dragged along by one face or the other and never coasts
  sprung,            // stiff, damped teeth and a light wheel in thick grease
};

// Last gear stage between the motor and the wheel; travel and speed are those at the wheel rim.
struct GearSpec {
  Play play = Play::none;
  double play_m = 0.0;
  double rim_mass_kg = 2.0;   // that the motor moves
  double eccentricity = 0.0;  // off-centre last gear: the wheel's speed ripples by this share over a turn
  double wheel_radius_m = 0.04;
};

class Gear {
 public:
  // The motor begins at the forward face of the play.
  Gear(const GearSpec& spec, double angle_rad)
      : spec_(spec), angle_rad_(angle_rad), wheel_m_(-0.5 * spec.play_m) {}

  // Returns the speed of the wheel.
  double step_m_s(double motor_m_s, double step_s);

  // Since the start.
  [[nodiscard]] double wheel_travel_m() const { return wheel_m_ + 0.5 * spec_.play_m; }
  [[nodiscard]] double wheel_angle_rad() const { return wheel_m_ / spec_.wheel_radius_m + angle_rad_; }

 private:
  void step_sprung(double motor_m_s, double step_s);

  GearSpec spec_;
  double angle_rad_;
  double motor_m_ = 0.0;
  double wheel_m_;
  double sprung_m_s_ = 0.0;
};

}  // namespace plants::third

#pragma once

namespace plants::second {

// LuGre friction of a gearbox or a sliding pair, as a force at the wheel rim.
struct FrictionSpec {
  double coulomb_n = 0.0;
  double breakaway_n = 0.0;
  double stribeck_speed_m_s = 0.01;
  double bristle_travel_m = 1.0e-4;  // deflection at which the pair begins to slide
};

class Friction {
 public:
  explicit Friction(const FrictionSpec& spec) : spec_(spec) {}

  // Force that opposes the motion (same sign as the speed when sliding).
  double force_n(double speed_m_s, double step_s);

 private:
  FrictionSpec spec_;
  double deflection_m_ = 0.0;
};

}  // namespace plants::second

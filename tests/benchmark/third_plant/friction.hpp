#pragma once

namespace plants::third {

// Dry friction in a gear, as a force at the wheel rim: LuGre (Canudas de Wit et al. 1995), or regularised.
struct FrictionSpec {
  double coulomb_n = 0.0;
  double breakaway_n = 0.0;
  double stribeck_m_s = 0.01;
  double bristle_travel_m = 2.0e-4;  // deflection at which it begins to slide
  double regularised_m_s = 0.0;      // 0 = LuGre; else speed within which the Coulomb force turns over
};

class Friction {
 public:
  Friction(const FrictionSpec& spec, double rim_mass_kg) : spec_(spec), rim_mass_kg_(rim_mass_kg) {}

  // Force that opposes the motion.
  double force_n(double speed_m_s, double step_s);

 private:
  double bristle_force_n(double speed_m_s, double step_s);

  FrictionSpec spec_;
  double rim_mass_kg_;
  double deflection_m_ = 0.0;
};

}  // namespace plants::third

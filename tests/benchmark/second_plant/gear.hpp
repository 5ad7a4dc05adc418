#pragma once

namespace plants::second {

// Elastic last gear stage between rotor and wheel, in rim units.
struct GearSpec {
  double stiffness_n_m = 2.0e4;
  double damping_n_s_m = 80.0;
  double lash_m = 0.0;        // free play at the rim
  double eccentricity = 0.0;  // off-centre output gear: ratio varies by this share over a wheel turn
};

struct GearForces {
  double on_rotor_n = 0.0;
  double on_wheel_n = 0.0;
};

class Gear {
 public:
  // Starts with the play taken up in the forward direction.
  explicit Gear(const GearSpec& spec) : spec_(spec), twist_m_(0.5 * spec.lash_m) {}

  GearForces forces(double rotor_m_s, double wheel_m_s, double angle_from_high_rad, double step_s);

 private:
  [[nodiscard]] double tooth_force_n(double twist_rate_m_s) const;

  GearSpec spec_;
  double twist_m_;
};

}  // namespace plants::second

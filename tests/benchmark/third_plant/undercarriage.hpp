#pragma once

#include "tests/benchmark/plants/wheels.hpp"

namespace plants::third {

// How the body goes with what its two wheels do on the floor.
struct UndercarriageSpec {
  double track_m = 0.25;  // between the points on which the tyres really bear
  double scrub = 0.0;   // drag of the contact patches: the turn rate is divided by 1 + scrub at fastest_turn
  int scrub_power = 1;  // and grows from none with this power of the turn rate
  double fastest_turn_rad_s = 2.0;
  double turn_loss_m = 0.0;       // creep of the tyres under side drag: forward speed lost per turn rate
  double side_brush_rad_s = 0.0;  // turn rate that a side brush adds while the wheels turn
  double caster_rad_m = 0.0;      // turn per metre by a caster that stands across
  double caster_trail_m = 0.012;
};

struct BodyMotion {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
};

class Undercarriage {
 public:
  explicit Undercarriage(const UndercarriageSpec& spec) : spec_(spec) {}

  BodyMotion step(const PerWheel<double>& floor_m_s, double step_s);

 private:
  [[nodiscard]] double scrubbed_rad_s(double turn_rad_s) const;
  [[nodiscard]] double creep_m_s(double forward_m_s, double turn_rad_s) const;
  [[nodiscard]] double brush_rad_s(const PerWheel<double>& floor_m_s) const;
  double caster_rad_s(double forward_m_s, double step_s);

  // It never comes quite in line, and so swings over the same side both ways.
  static constexpr double caster_rest_rad = 0.25;

  UndercarriageSpec spec_;
  double caster_rad_ = caster_rest_rad;  // 0 = trailing in forward travel
};

}  // namespace plants::third

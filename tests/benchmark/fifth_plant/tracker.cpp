#include "tests/benchmark/fifth_plant/tracker.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fifth {

Tracker::Tracker(const TrackerSpec& spec, const Pose& axle, const Random& random)
    : spec_(spec),
      late_(spec.latency_s, marker(axle)),
      x_noise_(spec.slow_noise_m, std::max(spec.smoothing_s, fine_step_s), random.child(0)),
      y_noise_(spec.slow_noise_m, std::max(spec.smoothing_s, fine_step_s), random.child(1)),
      smooth_(marker(axle)) {}

Pose Tracker::marker(const Pose& axle) const {
  return point_of_body(axle, spec_.marker_x_m, spec_.marker_y_m);
}

void Tracker::step(const Pose& axle) {
  const Pose newest = late_.step(marker(axle));
  const double share = spec_.smoothing_s > 0.0 ? -std::expm1(-fine_step_s / spec_.smoothing_s) : 1.0;
  smooth_.x_m += share * (newest.x_m - smooth_.x_m);
  smooth_.y_m += share * (newest.y_m - smooth_.y_m);
  smooth_.heading_rad += share * (newest.heading_rad - smooth_.heading_rad);
  noise_.x_m = x_noise_.step();
  noise_.y_m = y_noise_.step();
}

// Once and twice a turn.
double Tracker::shown_rad(double heading_rad) const {
  return heading_rad + spec_.iron_rad * std::sin(heading_rad + spec_.iron_phase_rad) +
         spec_.iron_twice_rad * std::sin(2.0 * heading_rad);
}

Pose Tracker::seen() const {
  return {smooth_.x_m + noise_.x_m, smooth_.y_m + noise_.y_m, shown_rad(smooth_.heading_rad)};
}

}  // namespace plants::fifth

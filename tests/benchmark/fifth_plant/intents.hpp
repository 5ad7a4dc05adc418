// What people intend, one class for each kind of errand.
#pragma once

#include "tests/benchmark/fifth_plant/person.hpp"

namespace plants::fifth {

std::unique_ptr<Intent> intend_joystick(const Style& style, const Random& random);
std::unique_ptr<Intent> intend_docking(const Style& style, const Random& random);
std::unique_ptr<Intent> intend_laps(const Style& style, const Random& random);
std::unique_ptr<Intent> intend_patrol(const Style& style, const Random& random);
std::unique_ptr<Intent> intend_creeping(const Style& style, const Random& random);
// `backward` lets it come back in reverse.
std::unique_ptr<Intent> intend_straight(const Style& style, const Random& random, bool backward);
std::unique_ptr<Intent> intend_turning(const Style& style, const Random& random);
std::unique_ptr<Intent> intend_errands(const Style& style, const Random& random);

// The turn that brings the robot round to a place.
double bearing_error_rad(const Pose& seen, double x_m, double y_m);

}  // namespace plants::fifth

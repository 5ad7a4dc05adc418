#include "model/geometry/pose.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"

using namespace wheelwright;
using std::numbers::pi;

TEST_CASE("A quarter circle ends one radius ahead and one to the left") {
  const Pose end = move_along_arc({}, {pi / 2.0, pi / 2.0}, 1.0);
  CHECK_THAT(end.x_m, WithinAbs(1.0, 1e-12));
  CHECK_THAT(end.y_m, WithinAbs(1.0, 1e-12));
  CHECK_THAT(end.theta_rad, WithinAbs(pi / 2.0, 1e-12));
}

TEST_CASE("Many short arcs end where one long arc ends") {
  const Twist twist{0.3, -1.7};
  Pose pose{1.0, -2.0, 0.4};
  const Pose once = move_along_arc(pose, twist, 3.6);
  for (int i = 0; i < 2000; ++i) pose = move_along_arc(pose, twist, 0.0018);
  CHECK_THAT(pose.x_m, WithinAbs(once.x_m, 1e-9));
  CHECK_THAT(pose.y_m, WithinAbs(once.y_m, 1e-9));
}

TEST_CASE("An arc is continuous where the turn rate goes through zero") {
  for (const double w : {1e-9, 1e-5, 1.9e-4, 2.1e-4}) {
    const Pose end = move_along_arc({}, {1.0, w}, 1.0);
    CHECK_THAT(end.x_m, WithinAbs(std::sin(w) / w, 1e-12));
    CHECK_THAT(end.y_m, WithinAbs((1.0 - std::cos(w)) / w, 1e-7));
  }
}

TEST_CASE("Wheel speeds and body motion are each other's inverse") {
  const WheelPair wheels{0.12, -0.31};
  const WheelPair back = wheels_of_twist(twist_of_wheels(wheels, 0.235), 0.235);
  CHECK_THAT(back.left, WithinAbs(wheels.left, 1e-15));
  CHECK_THAT(back.right, WithinAbs(wheels.right, 1e-15));
}

TEST_CASE("A faster right wheel turns the robot to the left") {
  CHECK(twist_of_wheels({0.1, 0.2}, 0.235).w_rad_s > 0.0);
}

TEST_CASE("Angles wrap to the half-open interval from minus pi to pi") {
  CHECK(wrap_angle(pi) == pi);
  CHECK(wrap_angle(-pi) == pi);
  CHECK_THAT(wrap_angle(7.0 * pi + 0.1), WithinAbs(-pi + 0.1, 1e-12));
}

TEST_CASE("A pose that is seen from another and placed there again is itself") {
  const Pose origin{0.3, -1.2, 2.1};
  const Pose pose{-0.7, 0.4, -0.9};
  const Pose again = compose(origin, between(origin, pose));
  CHECK_THAT(again.x_m, WithinAbs(pose.x_m, 1e-12));
  CHECK_THAT(again.y_m, WithinAbs(pose.y_m, 1e-12));
  CHECK_THAT(again.theta_rad, WithinAbs(pose.theta_rad, 1e-12));
}

// Where the response actions lead the robot: it has half a metre of free floor.
#include "model/brain/manoeuvre.hpp"

#include <cmath>
#include <set>

#include "model/geometry/pose.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

struct Walk {
  Pose end;
  double farthest_m = 0.0;
  std::set<double> sizes_m_s;
};

// Of a robot that does at once what is wanted.
Walk walk(const ResponsePlan& plan) {
  constexpr double period_s = 0.018;
  constexpr double wheel_base_m = 0.235;
  const auto actions = make_response_actions(plan, period_s);
  actions->restart();
  Walk walk;
  SensorFrame frame;
  frame.valid = frame.armed = true;
  WheelPair way_m;
  while (const auto order = actions->next(frame)) {
    const WheelPair& speed = order->speed_m_s;
    walk.end = move_along_arc(walk.end, twist_of_wheels(speed, wheel_base_m), period_s);
    walk.farthest_m = std::max(walk.farthest_m, std::hypot(walk.end.x_m, walk.end.y_m));
    for (const double one : {speed.left, speed.right}) {
      if (one != 0.0) walk.sizes_m_s.insert(std::abs(one));
    }
    way_m = {way_m.left + period_s * speed.left, way_m.right + period_s * speed.right};
    frame.ticks = {std::llround(way_m.left / 0.000444565), std::llround(way_m.right / 0.000444565)};
    ++frame.tick;
  }
  return walk;
}

}  // namespace

TEST_CASE(
    "After the response actions the robot is where it was, and it was never further than 0.3 m from there") {
  const Walk all = walk(ResponsePlan{});
  CHECK(std::hypot(all.end.x_m, all.end.y_m) < 0.02);
  CHECK(std::abs(wrap_angle(all.end.theta_rad)) < 0.05);
  CHECK(all.farthest_m < 0.3);
  CHECK(all.sizes_m_s.size() == 6);
}

TEST_CASE("After an odd number of repetitions the robot heads where it headed, and is less than 0.4 m away") {
  ResponsePlan plan;
  plan.repetitions = 3;
  const Walk three = walk(plan);
  CHECK(std::hypot(three.end.x_m, three.end.y_m) < 0.4);
  CHECK(std::abs(wrap_angle(three.end.theta_rad)) < 0.05);
}

TEST_CASE("Longer response actions, and many of them, come back as well") {
  ResponsePlan plan;
  plan.on_s = 4.0;
  plan.repetitions = 20;
  plan.speed_spread = 0.8;
  const Walk all = walk(plan);
  CHECK(std::hypot(all.end.x_m, all.end.y_m) < 0.05);
  CHECK(all.farthest_m < 0.47);  // two wheel bases
}

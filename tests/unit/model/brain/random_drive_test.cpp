#include "model/brain/random_drive.hpp"

#include <cmath>
#include <set>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

struct Driven {
  std::vector<WheelPair> speeds;
  std::vector<Pose> poses;  // after each period, of a robot that does at once what is wanted
};

Driven drive(const RandomDrivePlan& plan) {
  RobotLimits limits;
  RandomDrive random(plan, limits);
  Driven driven;
  Pose pose;
  while (const auto speed = random.next(pose)) {
    pose = move_along_arc(pose, twist_of_wheels(*speed, limits.wheel_base_m), limits.period_s);
    driven.speeds.push_back(*speed);
    driven.poses.push_back(pose);
  }
  return driven;
}

RandomDrivePlan plan_of(std::uint64_t seed) {
  RandomDrivePlan plan;
  plan.seed = seed;
  return plan;
}

double from_middle_m(const RandomDrivePlan& plan, const Pose& pose) {
  return std::hypot(pose.x_m - plan.ahead_m, pose.y_m);
}

}  // namespace

TEST_CASE("The same seed gives the same random drive, another seed another") {
  const auto first = drive(plan_of(7));
  const auto second = drive(plan_of(7));
  const auto other = drive(plan_of(8));
  REQUIRE(first.speeds.size() == second.speeds.size());
  std::size_t different = 0;
  for (std::size_t k = 0; k < first.speeds.size(); ++k) {
    REQUIRE(first.speeds[k].left == second.speeds[k].left);
    REQUIRE(first.speeds[k].right == second.speeds[k].right);
    if (first.speeds[k].left != other.speeds[k].left) ++different;
  }
  CHECK(2 * different > first.speeds.size());
}

TEST_CASE("A random drive enters its circle and stays in it, whatever the seed and its size") {
  for (const double radius_m : {0.2, 0.5}) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      auto plan = plan_of(seed);
      plan.radius_m = radius_m;
      bool was_inside = false;
      const auto driven = drive(plan);
      for (const Pose& pose : driven.poses) {
        const double distance_m = from_middle_m(plan, pose);
        was_inside = was_inside || distance_m <= radius_m;
        // Slowing down takes some way.
        REQUIRE(distance_m < (was_inside ? radius_m : plan.ahead_m) + 0.03);
      }
      INFO("seed " << seed << ", radius " << radius_m);
      CHECK(was_inside);
    }
  }
}

TEST_CASE("A tour leads all over the circle, on legs at the speed of the route and turns in place") {
  RandomDrivePlan plan;
  plan.tour_speed_m_s = 0.15;
  plan.duration_s = 200.0;
  const auto driven = drive(plan);
  const auto begin = static_cast<std::size_t>((1.0 - plan.tour_share) * plan.duration_s / 0.018);
  std::size_t straight = 0;
  std::size_t turning = 0;
  std::set<int> quadrants;
  for (std::size_t k = begin; k < driven.speeds.size(); ++k) {
    const WheelPair& speed = driven.speeds[k];
    const Twist twist = twist_of_wheels(speed, 0.235);
    // Curves let one wheel be faster than the middle of the axle.
    REQUIRE(std::abs(twist.v_m_s) <= 1.2 * plan.tour_speed_m_s + 1e-9);
    if (twist.v_m_s > 0.8 * plan.tour_speed_m_s && std::abs(twist.w_rad_s) < 0.1) ++straight;
    if (std::abs(twist.v_m_s) < 1e-9 && std::abs(twist.w_rad_s) > 0.3) ++turning;
    const Pose& pose = driven.poses[k];
    if (from_middle_m(plan, pose) > 0.4 * plan.radius_m)
      quadrants.insert((pose.x_m > plan.ahead_m ? 1 : 0) + (pose.y_m > 0.0 ? 2 : 0));
  }
  const auto ticks = driven.speeds.size() - begin;
  CHECK(3 * straight > ticks);
  CHECK(8 * turning > ticks);
  CHECK(quadrants.size() == 4);
}

TEST_CASE("Without a model there is no tour, and the random speeds last as long as both") {
  RandomDrivePlan plan;
  plan.duration_s = 20.0;
  RandomDrivePlan without_tour = plan;
  without_tour.tour_share = 0.0;
  RobotLimits limits;
  RandomDrive with_tour(plan, limits);
  RandomDrive random_alone(without_tour, limits);
  with_tour.restart(false);
  for (Pose pose;;) {
    const auto speed = with_tour.next(pose);
    const auto other = random_alone.next(pose);
    REQUIRE(speed.has_value() == other.has_value());
    if (!speed) break;
    REQUIRE(speed->left == other->left);
    pose = move_along_arc(pose, twist_of_wheels(*speed, limits.wheel_base_m), limits.period_s);
  }
}

TEST_CASE("A random drive lasts as long with a tour as without, but for the rest before the tour") {
  RandomDrivePlan plan;
  const auto with_tour = drive(plan).speeds.size();
  plan.tour_share = 0.0;
  const auto without = drive(plan).speeds.size();
  CHECK(with_tour > without);
  CHECK(with_tour < without + 50);
}

TEST_CASE("Speeds of a random drive are normally distributed, change within bounds, and end at rest") {
  RandomDrivePlan plan;
  plan.tour_share = 0.0;
  plan.duration_s = 3000.0;
  plan.largest_change_m_s = 1.0;
  const auto driven = drive(plan);
  double sum = 0.0;
  double squares = 0.0;
  double fourth_powers = 0.0;
  for (const WheelPair& speed : driven.speeds) {
    sum += speed.left;
    squares += speed.left * speed.left;
    fourth_powers += std::pow(speed.left, 4);
  }
  const auto n = static_cast<double>(driven.speeds.size());
  const double deviation = std::sqrt(squares / n);
  CHECK(std::abs(sum / n) < 0.005);
  // The limit of 0.3 m/s cuts the tails off at three standard deviations.
  CHECK_THAT(deviation, WithinRel(plan.spread_m_s, 0.05));
  CHECK_THAT(fourth_powers / n / std::pow(deviation, 4), WithinAbs(3.0, 0.3));
  CHECK(driven.speeds.back().left == 0.0);
  CHECK(driven.speeds.back().right == 0.0);

  plan = plan_of(3);
  WheelPair before;
  for (const WheelPair& speed : drive(plan).speeds) {
    REQUIRE(std::abs(speed.left - before.left) <= plan.largest_change_m_s + 1e-12);
    REQUIRE(std::abs(speed.right - before.right) <= plan.largest_change_m_s + 1e-12);
    before = speed;
  }
}

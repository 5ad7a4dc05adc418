#include "tests/benchmark/third_plant/planner.hpp"

#include <algorithm>
#include <cmath>

namespace plants::third {

std::string name_of(Style style) {
  switch (style) {
    case Style::random_steps:
      return "random_steps";
    case Style::joystick:
      return "joystick";
    case Style::go_and_turn:
      return "go_and_turn";
    case Style::slow_fast_mixture:
      return "slow_fast_mixture";
    case Style::one_speed:
      break;
  }
  return "one_speed";
}

std::vector<Segment> Planner::next(double now_s, const Pose& seen) {
  constexpr double forever_s = 1000.0;
  if (style_ == Style::one_speed)
    return {hold(forever_s, {0.5 * limits_.fastest_m_s, 0.5 * limits_.fastest_m_s})};
  if (style_ == Style::slow_fast_mixture && now_s > pace_until_s_) change_pace(now_s);
  return style_ == Style::go_and_turn ? next_leg(seen) : next_step(seen);
}

void Planner::change_pace(double now_s) {
  slow_pace_ = pace_until_s_ > 0.0 ? !slow_pace_ : random_.chance(0.5);
  const double segment = slow_pace_ ? 0.4 + 1.2 * habits_.slow_share : 1.0;
  pace_until_s_ = now_s + random_.uniform(6.0, 11.0) * segment;
}

std::vector<Segment> Planner::next_step(const Pose& seen) {
  const bool mixture = style_ == Style::slow_fast_mixture;
  if (random_.chance(mixture ? 0.12 : 0.16)) return {rest(random_.uniform(0.4, 1.3))};
  if (mixture && random_.chance(slow_pace_ ? 0.4 : 0.08)) return slow_triangle();
  return {staying_in_room(seen, [this] { return draw_step(); })};
}

Segment Planner::draw_step() {
  const double pace = random_.chance(0.5) ? 1.0 : 0.6;
  double duration_s = random_.log_uniform(0.3, 3.0);
  const bool slow = style_ == Style::slow_fast_mixture ? slow_pace_ : random_.chance(habits_.slow_share);
  if (slow) return draw_fine_step(duration_s);
  double forward_m_s = random_.uniform(0.2, 1.0) * pace * limits_.fastest_m_s;
  if (limits_.reverses && !random_.chance(0.55)) forward_m_s = -forward_m_s;
  double turn_rad_s = limits_.fastest_turn_rad_s * random_.uniform(-1.0, 1.0);
  constexpr double straight_share = 0.2;
  const double dice = random_.uniform(0.0, 1.0);
  if (dice < straight_share) {
    turn_rad_s = 0.0;
  } else if (dice < straight_share + habits_.pivot_share) {
    forward_m_s *= random_.uniform(0.0, 0.3);
    turn_rad_s = limits_.fastest_turn_rad_s * random_.signed_uniform(0.3, 1.0);
  }
  if (!limits_.turns) turn_rad_s = 0.0;
  if (!limits_.reverses) {
    const double tightest_rad_s = 1.8 * forward_m_s / limits_.wheel_base_m;
    turn_rad_s = std::clamp(turn_rad_s, -tightest_rad_s, tightest_rad_s);
  }
  if (style_ == Style::joystick) duration_s = random_.uniform(0.5, 2.0);
  return motion(duration_s, forward_m_s, turn_rad_s, limits_);
}

// Each wheel by itself.
Segment Planner::draw_fine_step(double duration_s) {
  constexpr double shortest_s = 0.6;
  const auto draw_m_s = [this] { return habits_.slow_m_s * random_.signed_uniform(0.1, 1.0); };
  PerWheel<double> command_m_s{};
  command_m_s[left_side] = draw_m_s();
  command_m_s[right_side] = random_.chance(0.4) ? command_m_s[left_side] : draw_m_s();
  if (!limits_.reverses)
    for (double& speed_m_s : command_m_s) speed_m_s = std::abs(speed_m_s);
  if (!limits_.turns) command_m_s[right_side] = command_m_s[left_side];
  return hold(std::max(duration_s, shortest_s), command_m_s);
}

// Slowly up, through zero, and back.
std::vector<Segment> Planner::slow_triangle() {
  const double top_m_s = habits_.slow_m_s * random_.signed_uniform(0.7, 1.6);
  const double quarter_s = random_.uniform(0.8, 2.2);
  const double right = random_.chance(0.3) ? -1.0 : 1.0;
  const PerWheel<double> top{top_m_s, right * top_m_s};
  const PerWheel<double> bottom{-top_m_s, -right * top_m_s};
  std::vector<Segment> plan{{quarter_s, {}, top}, {2.0 * quarter_s, top, bottom}, {quarter_s, bottom, {}}};
  if (random_.chance(0.5)) plan.push_back(rest(random_.uniform(0.3, 0.8)));
  return plan;
}

std::vector<Segment> Planner::next_leg(const Pose& seen) {
  const bool slow = random_.chance(habits_.slow_share);
  const double speed_m_s =
      limits_.fastest_m_s * (slow ? random_.uniform(0.08, 0.25) : random_.uniform(0.35, 1.0));
  const bool straight = random_.chance(0.55) || !limits_.turns;
  std::vector<Segment> plan{
      staying_in_room(seen, [&] { return straight ? draw_straight(speed_m_s) : draw_arc(speed_m_s); })};
  if (random_.chance(0.8)) plan.push_back(rest(random_.uniform(0.25, 0.8)));
  if (limits_.turns && random_.chance(0.65)) {
    plan.push_back(draw_pivot());
    plan.push_back(rest(random_.uniform(0.25, 0.8)));
  }
  return plan;
}

Segment Planner::draw_straight(double speed_m_s) {
  constexpr double longest_s = 5.0;
  const double length_m = std::min(random_.uniform(0.15, 0.9), longest_s * speed_m_s);
  const double direction = random_.chance(0.45) ? -1.0 : 1.0;
  return motion(length_m / speed_m_s, direction * speed_m_s, 0.0, limits_);
}

Segment Planner::draw_arc(double speed_m_s) {
  constexpr double longest_s = 4.0;
  const double direction = random_.chance(0.4) ? -1.0 : 1.0;
  const double turn_rad_s = limits_.fastest_turn_rad_s * random_.signed_uniform(0.3, 0.9);
  const double duration_s = std::min(1.2 * random_.uniform(0.6, 2.2) / std::abs(turn_rad_s), longest_s);
  return motion(duration_s, direction * std::min(speed_m_s, 0.8 * limits_.fastest_m_s), turn_rad_s, limits_);
}

Segment Planner::draw_pivot() {
  constexpr double longest_s = 4.0;
  const double direction = random_.sign();
  const double share = random_.chance(0.3) ? random_.uniform(0.12, 0.35) : random_.uniform(0.35, 1.0);
  const double turn_rad_s = limits_.fastest_turn_rad_s * share;
  const double angle_rad = std::min(random_.uniform(0.4, 3.0), longest_s * turn_rad_s);
  return motion(angle_rad / turn_rad_s, 0.0, direction * turn_rad_s, limits_);
}

// Of several draws the first that ends in the room, or else the one that ends nearest to it and faces it.
Segment Planner::staying_in_room(const Pose& seen, const std::function<Segment()>& draw) const {
  constexpr int draws = 40;
  constexpr double facing_m = 0.15;
  Segment best;
  double min_m = 1.0e9;
  for (int attempt = 0; attempt < draws && min_m >= habits_.room_radius_m; ++attempt) {
    const Segment segment = draw();
    const Pose end = pose_after(segment, seen, limits_.wheel_base_m);
    double distance_m = std::hypot(end.x_m - habits_.room_x_m, end.y_m - habits_.room_y_m);
    if (distance_m > habits_.room_radius_m) {
      const double home_rad = std::atan2(habits_.room_y_m - end.y_m, habits_.room_x_m - end.x_m);
      distance_m += facing_m * (1.0 - std::abs(std::cos(home_rad - end.heading_rad)));
    }
    if (distance_m >= min_m) continue;
    min_m = distance_m;
    best = segment;
  }
  return best;
}

}  // namespace plants::third

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/third_plant/segment.hpp"

namespace plants::third {

enum class Style {
  random_steps,
  joystick,           // random steps by a soft hand
  go_and_turn,        // straights, arcs and pivots with stops between them
  slow_fast_mixture,  // seconds of fine manoeuvring and seconds of driving
  one_speed,          // straight ahead and nothing else
};

std::string name_of(Style style);

struct DriveHabits {
  double slow_share = 0.2;  // of the manoeuvres
  double slow_m_s = 0.08;   // largest speed of fine manoeuvring
  double pivot_share = 0.15;
  double room_x_m = 0.0;
  double room_y_m = 0.0;
  double room_radius_m = 1.3;
};

// Draws what someone does next who sees the robot and keeps it in the room.
class Planner {
 public:
  Planner(Style style, const DriveHabits& habits, const CommandLimits& limits, const Random& random)
      : style_(style), habits_(habits), limits_(limits), random_(random) {}

  std::vector<Segment> next(double now_s, const Pose& seen);

 private:
  std::vector<Segment> next_step(const Pose& seen);
  std::vector<Segment> next_leg(const Pose& seen);
  std::vector<Segment> slow_triangle();
  void change_pace(double now_s);
  Segment draw_step();
  Segment draw_fine_step(double duration_s);
  Segment draw_straight(double speed_m_s);
  Segment draw_arc(double speed_m_s);
  Segment draw_pivot();
  Segment staying_in_room(const Pose& seen, const std::function<Segment()>& draw) const;

  Style style_;
  DriveHabits habits_;
  CommandLimits limits_;
  Random random_;
  bool slow_pace_ = false;
  double pace_until_s_ = 0.0;
};

}  // namespace plants::third

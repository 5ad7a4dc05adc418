#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/sixth_plant/drive_script.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

struct Range {
  double low;
  double high;
};

// The hand that drives: it holds a speed and a turn rate, follows its target by a ramp, and keeps in mind
// where the robot should be. Of one motion the duration is drawn first, then the turn rate, then the speed.
class Hand {
 public:
  Hand(const Robot& robot, const Pose& start, const Random& random);

  // One row of the log.
  void row(double forward_m_s, double turn_rad_s);
  void go(double forward_m_s, double turn_rad_s, double seconds);
  void rest(const Range& seconds);
  void go_straight(const Range& speed_share, const Range& seconds);
  // Way is 1 or -1.
  void go_curved(double way, const Range& speed_share, const Range& turn_rad_s, const Range& seconds);
  // On the spot, to either side.
  void spin(const Range& turn_rad_s, const Range& seconds);
  void turn_by(double angle_rad, double turn_rad_s);

  double drawn_m_s(const Range& speed_share);
  double drawn(const Range& range) { return random.uniform(range.low, range.high); }

  [[nodiscard]] double now_s() const;
  // From the middle of the room, and the direction to it as the robot sees it.
  [[nodiscard]] double away_m() const;
  [[nodiscard]] double homeward_rad() const;
  [[nodiscard]] bool faces_outward() const;
  [[nodiscard]] const Pose& place() const { return place_; }
  [[nodiscard]] const Robot& robot() const { return robot_; }
  [[nodiscard]] const DriveScript& script() const { return script_; }

  double ramp_s = 0.0;  // from rest to the top speed
  Random random;

 private:
  Robot robot_;
  Pose place_;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
  DriveScript script_;
};

}  // namespace plants::sixth

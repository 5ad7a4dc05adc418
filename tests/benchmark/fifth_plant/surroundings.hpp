#pragma once

#include "tests/benchmark/fifth_plant/robot.hpp"
#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"

namespace plants::fifth {

struct Wrench {
  double forward_n = 0.0;
  double left_n = 0.0;
  double yaw_n_m = 0.0;
};

Wrench operator+(const Wrench& one, const Wrench& other);

struct BodyMotion {
  Pose pose;  // of the middle of the axle; heading unwrapped
  double forward_m_s = 0.0;
  double left_m_s = 0.0;
  double turn_rad_s = 0.0;
};

// The floor's force on the body apart from what the tyres transmit.
Wrench floor_wrench(const Robot& robot, const BodyMotion& motion);
// Drags in proportion to the turn, a brush, and a cable to the place where the robot set out.
Wrench drag_wrench(const BodySpec& body, const BodyMotion& motion, bool driving, const Pose& anchor);

// A castor on a trailing arm, whose swivel is not free.
class Castor {
 public:
  explicit Castor(const BodySpec& body) : body_(body) {}
  Wrench step(const BodyMotion& motion);

 private:
  BodySpec body_;
  double swivel_rad_ = 0.0;
};

// A box that slides to and fro in its tray.
class SlidingLoad {
 public:
  explicit SlidingLoad(const BodySpec& body) : body_(body) {}
  Wrench step(double forward_m_s);

 private:
  BodySpec body_;
  double speed_m_s_ = 0.0;
  double place_m_ = 0.0;
};

// A mast that looks to the other side now and then, by itself.
class Turret {
 public:
  Turret(const BodySpec& body, const Random& random);
  Wrench step();

 private:
  BodySpec body_;
  Random random_;
  double time_s_ = 0.0;
  double swing_from_s_ = no_limit;
  double side_ = 1.0;
};

}  // namespace plants::fifth

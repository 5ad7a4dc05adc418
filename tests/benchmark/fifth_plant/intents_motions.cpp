// Driving by the motion alone.
#include <algorithm>
#include <cmath>

#include "tests/benchmark/fifth_plant/intents.hpp"

namespace plants::fifth {

namespace {

// Holds a motion for a while and then picks another one.
class Held : public Intent {
 public:
  Held(const Style& style, const Random& random) : style_(style), random_(random) {}

  Twist want(double time_s, const Pose& seen) override {
    if (time_s >= until_s_) {
      held_ = pick(time_s, seen);
      until_s_ = time_s + lasts_s();
    }
    return held_;
  }

 protected:
  virtual Twist pick(double time_s, const Pose& seen) = 0;
  virtual double lasts_s() = 0;

  Style style_;
  Random random_;

 private:
  Twist held_;
  double until_s_ = 0.0;
};

class Joystick : public Held {
 public:
  using Held::Held;

 protected:
  Twist pick(double /*time_s*/, const Pose& seen) override {
    constexpr double room_m = 2.0;
    if (random_.chance(0.12)) return {};
    const double speed_m_s = random_.uniform(0.15, 1.0) * style_.top_m_s;
    const double turn_rad_s =
        random_.chance(0.3) ? 0.0 : random_.signed_uniform(0.1, 1.0) * style_.turn_rad_s;
    if (std::hypot(seen.x_m, seen.y_m) > room_m) return homeward(seen, speed_m_s);
    if (random_.chance(0.15)) return {0.0, turn_rad_s};
    return {random_.chance(0.35) ? -speed_m_s : speed_m_s, turn_rad_s};
  }
  double lasts_s() override { return random_.uniform(0.5, 2.2); }

 private:
  // Forward or backward, whichever leads into the room.
  [[nodiscard]] Twist homeward(const Pose& seen, double speed_m_s) const {
    const double off_rad = bearing_error_rad(seen, 0.0, 0.0);
    const double way = std::cos(off_rad) >= 0.0 ? 1.0 : -1.0;
    return {way * speed_m_s, std::clamp(way * std::sin(off_rad), -0.5, 0.5) * style_.turn_rad_s};
  }
};

// Slow triangles of speed through zero, turns that come and go still slower.
class Creeping : public Intent {
 public:
  Creeping(const Style& style, Random random)
      : size_m_s_(random.uniform(0.3, 0.5) * style.top_m_s),
        forward_s_(random.uniform(7.0, 12.0)),
        turn_s_(random.uniform(15.0, 23.0)),
        turn_rad_s_(random.signed_uniform(0.2, 0.5) * style.turn_rad_s) {}

  Twist want(double time_s, const Pose& /*seen*/) override {
    return {size_m_s_ * triangle(time_s / forward_s_), turn_rad_s_ * triangle(time_s / turn_s_ + 0.1)};
  }

 private:
  static double triangle(double turns) {
    const double phase = turns - std::floor(turns);
    return phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0;
  }

  double size_m_s_;
  double forward_s_;
  double turn_s_;
  double turn_rad_s_;
};

class Straight : public Held {
 public:
  Straight(const Style& style, const Random& random, bool backward)
      : Held(style, random), backward_(backward) {}

 protected:
  Twist pick(double /*time_s*/, const Pose& /*seen*/) override {
    if (random_.chance(0.25)) return {};
    if (backward_) way_ = -way_;
    return {way_ * random_.uniform(0.12, 1.0) * style_.top_m_s, 0.0};
  }
  double lasts_s() override { return random_.uniform(1.0, 3.5); }

 private:
  bool backward_;
  double way_ = 1.0;
};

class Turning : public Held {
 public:
  using Held::Held;

 protected:
  Twist pick(double /*time_s*/, const Pose& /*seen*/) override {
    if (random_.chance(0.1)) return {};
    const double turn_rad_s = random_.signed_uniform(0.1, 1.0) * style_.turn_rad_s;
    const bool on_the_spot = random_.chance(0.4);
    const double speed_m_s = on_the_spot ? 0.0 : random_.uniform(0.1, 0.65) * style_.top_m_s;
    return {random_.chance(0.25) ? -speed_m_s : speed_m_s, turn_rad_s};
  }
  double lasts_s() override { return random_.uniform(1.0, 3.2); }
};

// The stick is at a speed or at rest, and somebody is in a hurry.
class Errands : public Held {
 public:
  using Held::Held;

 protected:
  Twist pick(double /*time_s*/, const Pose& seen) override {
    moving_ = !moving_ || random_.chance(0.3);
    if (!moving_) return {};
    const double speed_m_s = random_.uniform(0.45, 1.0) * style_.top_m_s;
    const double off_rad = bearing_error_rad(seen, 0.0, 0.0);
    const bool far = std::hypot(seen.x_m, seen.y_m) > 1.5;
    const double way = far ? (std::cos(off_rad) >= 0.0 ? 1.0 : -1.0) : random_.sign();
    const double turn_rad_s =
        random_.chance(0.4) ? 0.0 : random_.signed_uniform(0.1, 0.6) * style_.turn_rad_s;
    return {way * speed_m_s, turn_rad_s};
  }
  double lasts_s() override { return random_.uniform(0.7, 1.8); }

 private:
  bool moving_ = false;
};

}  // namespace

std::unique_ptr<Intent> intend_joystick(const Style& style, const Random& random) {
  return std::make_unique<Joystick>(style, random);
}

std::unique_ptr<Intent> intend_creeping(const Style& style, const Random& random) {
  return std::make_unique<Creeping>(style, random);
}

std::unique_ptr<Intent> intend_straight(const Style& style, const Random& random, bool backward) {
  return std::make_unique<Straight>(style, random, backward);
}

std::unique_ptr<Intent> intend_turning(const Style& style, const Random& random) {
  return std::make_unique<Turning>(style, random);
}

std::unique_ptr<Intent> intend_errands(const Style& style, const Random& random) {
  return std::make_unique<Errands>(style, random);
}

std::unique_ptr<Intent> make_intent(Programme programme, const Style& style, const Random& random) {
  switch (programme) {
    case Programme::teleoperation:
      return intend_joystick(style, random);
    case Programme::docking:
      return intend_docking(style, random);
    case Programme::laps:
      return intend_laps(style, random);
    case Programme::patrol:
      return intend_patrol(style, random);
    case Programme::slow:
      return intend_creeping(style, random);
    case Programme::corridor:
      return intend_straight(style, random, true);
    case Programme::straight_on:
      return intend_straight(style, random, false);
    case Programme::turning:
      return intend_turning(style, random);
    case Programme::errands:
      break;
  }
  return intend_errands(style, random);
}

}  // namespace plants::fifth

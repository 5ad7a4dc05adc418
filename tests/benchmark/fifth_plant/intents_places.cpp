// Driving to places.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/fifth_plant/intents.hpp"

namespace plants::fifth {

namespace {

class Docking : public Intent {
 public:
  Docking(const Style& style, const Random& random) : style_(style), random_(random) { set_out(); }

  Twist want(double time_s, const Pose& seen) override {
    if (until_s_ == 0.0) until_s_ = time_s + 4.0;
    const double to_dock_m = std::hypot(seen.x_m, seen.y_m);
    const bool arrived = phase_ == Phase::approach && to_dock_m < 0.08;
    const bool there = phase_ == Phase::drift && std::hypot(seen.x_m - x_m_, seen.y_m - y_m_) < 0.2;
    if (arrived || there || time_s > until_s_) advance(time_s);
    return act(seen, to_dock_m);
  }

 private:
  enum class Phase { drift, approach, docked, back_out, spin };

  void set_out() {
    x_m_ = random_.uniform(0.9, 2.2);
    y_m_ = random_.uniform(-0.9, 0.9);
    spin_rad_s_ = random_.signed_uniform(0.35, 0.9) * style_.turn_rad_s;
    speed_m_s_ = random_.uniform(0.5, 0.95) * style_.top_m_s;
  }

  void advance(double time_s) {
    phase_ = static_cast<Phase>((static_cast<int>(phase_) + 1) % 5);
    if (phase_ == Phase::drift) set_out();
    const double lasts_s = phase_ == Phase::docked     ? random_.uniform(0.5, 1.2)
                           : phase_ == Phase::back_out ? random_.uniform(1.2, 2.6)
                           : phase_ == Phase::spin     ? random_.uniform(0.8, 2.2)
                                                       : random_.uniform(6.0, 10.0);
    until_s_ = time_s + lasts_s;
  }

  [[nodiscard]] Twist act(const Pose& seen, double to_dock_m) const {
    if (phase_ == Phase::docked) return {};
    if (phase_ == Phase::back_out) return {-0.5 * speed_m_s_, 0.0};
    if (phase_ == Phase::spin) return {-0.1 * speed_m_s_, spin_rad_s_};
    const bool docking = phase_ == Phase::approach;
    const double off_rad = bearing_error_rad(seen, docking ? 0.0 : x_m_, docking ? 0.0 : y_m_);
    const double ahead = std::max(0.0, std::cos(off_rad));
    const double speed_m_s = docking ? std::clamp(0.5 * to_dock_m, 0.05, speed_m_s_) : speed_m_s_;
    return {speed_m_s * ahead, std::clamp(1.6 * off_rad, -style_.turn_rad_s, style_.turn_rad_s)};
  }

  Style style_;
  Random random_;
  Phase phase_ = Phase::drift;
  double until_s_ = 0.0;
  double x_m_ = 0.0;
  double y_m_ = 0.0;
  double spin_rad_s_ = 0.0;
  double speed_m_s_ = 0.0;
};

class Patrol : public Intent {
 public:
  Patrol(const Style& style, const Random& random) : style_(style), random_(random) { choose(); }

  Twist want(double time_s, const Pose& seen) override {
    if (time_s < rest_until_s_) return {};
    const double away_m = std::hypot(seen.x_m - x_m_, seen.y_m - y_m_);
    if (away_m < 0.15 || time_s > give_up_s_) {
      choose();
      rest_until_s_ = time_s + random_.uniform(0.4, 1.6);
      give_up_s_ = rest_until_s_ + random_.uniform(6.0, 9.0);
      return {};
    }
    const double off_rad = bearing_error_rad(seen, x_m_, y_m_);
    constexpr double well_aimed_rad = 0.35;
    const double turn_rad_s = std::clamp(2.0 * off_rad, -spin_rad_s_, spin_rad_s_);
    if (std::abs(off_rad) > well_aimed_rad) return {0.0, turn_rad_s};
    return {std::clamp(away_m, 0.12, speed_m_s_), turn_rad_s};
  }

 private:
  void choose() {
    x_m_ = random_.uniform(-1.8, 1.8);
    y_m_ = random_.uniform(-1.8, 1.8);
    speed_m_s_ = random_.uniform(0.35, 1.0) * style_.top_m_s;
    spin_rad_s_ = random_.uniform(0.4, 1.0) * style_.turn_rad_s;
  }

  Style style_;
  Random random_;
  double rest_until_s_ = 0.0;
  double give_up_s_ = 9.0;
  double x_m_ = 0.0;
  double y_m_ = 0.0;
  double speed_m_s_ = 0.3;
  double spin_rad_s_ = 0.5;
};

// Round a track with two straights, now one way round and then, after a wide turn, the other way.
class Laps : public Intent {
 public:
  Laps(const Style& style, const Random& random) : style_(style), random_(random), way_(random_.sign()) {}

  Twist want(double time_s, const Pose& seen) override {
    if (time_s > turn_back_s_) {
      way_ = -way_;
      turn_back_s_ += random_.uniform(14.0, 24.0);
    }
    if (time_s > change_s_) {
      speed_m_s_ = random_.uniform(0.3, 0.9) * style_.top_m_s;
      change_s_ = time_s + random_.uniform(1.5, 5.0);
    }
    const double angle_rad = std::atan2(seen.y_m / 0.9, seen.x_m / 1.6) + way_ * 0.6;
    const double off_rad = bearing_error_rad(seen, 1.6 * std::cos(angle_rad), 0.9 * std::sin(angle_rad));
    const double slower = std::max(0.35, std::cos(off_rad));
    return {slower * speed_m_s_, std::clamp(1.8 * off_rad, -style_.turn_rad_s, style_.turn_rad_s)};
  }

 private:
  Style style_;
  Random random_;
  double way_;
  double turn_back_s_ = 18.0;
  double change_s_ = 0.0;
  double speed_m_s_ = 0.3;
};

}  // namespace

double bearing_error_rad(const Pose& seen, double x_m, double y_m) {
  return wrapped_rad(std::atan2(y_m - seen.y_m, x_m - seen.x_m) - seen.heading_rad);
}

std::unique_ptr<Intent> intend_docking(const Style& style, const Random& random) {
  return std::make_unique<Docking>(style, random);
}

std::unique_ptr<Intent> intend_patrol(const Style& style, const Random& random) {
  return std::make_unique<Patrol>(style, random);
}

std::unique_ptr<Intent> intend_laps(const Style& style, const Random& random) {
  return std::make_unique<Laps>(style, random);
}

}  // namespace plants::fifth

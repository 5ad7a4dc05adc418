// caster_kick: a short yaw disturbance after the direction of travel flips.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr double moving_m_s = 0.005;

class CasterKick final : public EffectOf<CasterKick> {
 public:
  explicit CasterKick(const EffectArguments& arguments)
      : angle_rad_(arguments.parameters[0]),
        distance_m_(arguments.parameters[1]),
        aside_(arguments.parameters[2]),
        alternates_(arguments.variant == 1) {}

  // The caster's swing grows by itself once begun and settles as it ends: a logistic curve of the distance
  // travelled since the flip. Who turns back half-way has that half of it to swing back.
  void body(Twist& twist, const Surroundings& around) override {
    const double v = twist.v_m_s;
    if (std::abs(v) > moving_m_s) {
      const double direction = std::copysign(1.0, v);
      if (direction_ != 0.0 && direction != direction_) {
        swung_ = std::clamp(1.0 - swung_, aside_, 1.0 - aside_);
        kick_rad_ = (alternates_ ? direction * angle_rad_ : angle_rad_) / (1.0 - aside_);
      }
      direction_ = direction;
    }
    const double ahead = (1.0 - swung_) * std::exp(-std::abs(v) * around.period_s / distance_m_);
    const double before = swung_;
    swung_ /= swung_ + ahead;
    twist.w_rad_s += kick_rad_ * (swung_ - before) / around.period_s;
  }
  void reset() override {
    direction_ = 0.0;
    kick_rad_ = 0.0;
    swung_ = 1.0;
  }

 private:
  double angle_rad_;
  double distance_m_;
  double aside_;
  bool alternates_;
  double direction_ = 0.0;  // of travel, once it has moved
  double kick_rad_ = 0.0;   // of the present swing
  double swung_ = 1.0;      // share of it
};

// What turns the robot by as much as that is no caster's swing.
bool only_kicks(std::span<const double> parameters, double) {
  constexpr double largest_kick_rad = 0.5;
  return std::abs(parameters[0]) < largest_kick_rad;
}

}  // namespace

EffectInfo caster_kick() {
  EffectInfo info{
      "caster_kick",
      "a short yaw disturbance after the direction of travel flips",
      "A caster swings round and pushes the robot aside while it does. 'same': to the same side at every "
      "flip, "
      "'alternating': to one side when it begins to go forward, to the other when backward.",
      {{"same", EffectStage::body}, {"alternating", EffectStage::body}},
      {{"angle", "rad", "turn that one kick makes in all", -1.0, 1.0, {-0.05, -0.02, 0.02, 0.05}, 0.002},
       {"distance",
        "m",
        "of travel in which the swing grows or settles to 1/e",
        0.003,
        0.5,
        {0.015, 0.05},
        0.0,
        false},
       {"aside",
        "1",
        "share of its swing at which the caster stands at the flip: little, and the kick comes late",
        0.001,
        0.5,
        {0.01, 0.3},
        0.0,
        false}},
      {.reference = true, .reversal = true},
      [](const EffectArguments& arguments) { return std::make_unique<CasterKick>(arguments); },
      true};
  info.in_character = only_kicks;
  return info;
}

}  // namespace wheelwright::effects

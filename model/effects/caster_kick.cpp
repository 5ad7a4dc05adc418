// caster_kick: a short yaw disturbance after the direction of travel flips.
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
        alternates_(arguments.variant == 1) {}

  // The kick turns the robot by `angle` in all, spread over the distance travelled since the flip as
  // exp(-distance).
  void body(Twist& twist, const Surroundings& around) override {
    const double v = twist.v_m_s;
    if (std::abs(v) > moving_m_s) {
      const double direction = std::copysign(1.0, v);
      if (direction_ != 0.0 && direction != direction_)
        left_rad_ = alternates_ ? direction * angle_rad_ : angle_rad_;
      direction_ = direction;
    }
    const double kick = -left_rad_ * std::expm1(-std::abs(v) * around.period_s / distance_m_);
    left_rad_ -= kick;
    twist.w_rad_s += kick / around.period_s;
  }
  void reset() override {
    direction_ = 0.0;
    left_rad_ = 0.0;
  }

 private:
  double angle_rad_;
  double distance_m_;
  bool alternates_;
  double direction_ = 0.0;  // of travel, once it has moved
  double left_rad_ = 0.0;   // of the kick
};

}  // namespace

EffectInfo caster_kick() {
  return {"caster_kick",
          "a short yaw disturbance after the direction of travel flips",
          "A caster swings round and pushes the robot aside while it does. 'same': to the same side at every "
          "flip, "
          "'alternating': to one side when it begins to go forward, to the other when backward.",
          {{"same", EffectStage::body}, {"alternating", EffectStage::body}},
          {{"angle", "rad", "turn that one kick makes in all", -1.0, 1.0, {-0.05, -0.02, 0.02, 0.05}, 0.002},
           {"distance", "m", "of travel over which it fades to 1/e", 0.003, 0.5, {0.015, 0.05}, 0.0, false}},
          {.reference = true, .reversal = true},
          [](const EffectArguments& arguments) { return std::make_unique<CasterKick>(arguments); },
          true};
}

}  // namespace wheelwright::effects

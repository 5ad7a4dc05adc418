// lever_arm: the reference point that was measured is not the middle of the axle.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class LeverArm final : public EffectOf<LeverArm> {
 public:
  explicit LeverArm(const EffectArguments& arguments)
      : forward_m_(arguments.parameters[0]), left_m_(arguments.parameters[1]) {}

  Pose observed(const Pose& axle) const override {
    const double c = std::cos(axle.theta_rad);
    const double s = std::sin(axle.theta_rad);
    return {axle.x_m + c * forward_m_ - s * left_m_, axle.y_m + s * forward_m_ + c * left_m_, axle.theta_rad};
  }

 private:
  double forward_m_;
  double left_m_;
};

}  // namespace

EffectInfo lever_arm() {
  return {"lever_arm",
          "the reference point that was measured is not the middle of the axle",
          "The marker or antenna is mounted off the axle: turning on the spot draws a circle. No motion of "
          "the robot, "
          "but of what was measured.",
          {{"", EffectStage::observation}},
          {{"forward", "m", "of the measured point, ahead of the axle", -0.5, 0.5, {0.02}},
           {"left", "m", "of the measured point, to the left", -0.5, 0.5, {0.02}}},
          {.reference = true, .place = true, .turning = true},
          [](const EffectArguments& arguments) { return std::make_unique<LeverArm>(arguments); }};
}

}  // namespace wheelwright::effects

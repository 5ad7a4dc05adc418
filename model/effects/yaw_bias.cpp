// yaw_bias: the robot turns when it should not, at a constant rate while driving.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr double driving_m_s = 0.01;  // below it the bias fades with the speed

class YawBias final : public EffectOf<YawBias> {
 public:
  explicit YawBias(const EffectArguments& arguments)
      : rate_(arguments.parameters[0]), on_the_spot_too_(arguments.variant == 1) {}

  void body(Twist& twist, const StepContext& context) override {
    const WheelPair& wheels = context.next_speed_m_s;
    const double speed =
        on_the_spot_too_ ? std::max(std::abs(wheels.left), std::abs(wheels.right)) : std::abs(twist.v_m_s);
    twist.w_rad_s += rate_ * std::min(1.0, speed / driving_m_s);
  }

 private:
  double rate_;
  bool on_the_spot_too_;
};

}  // namespace

EffectInfo yaw_bias() {
  return {"yaw_bias",
          "the robot turns when it should not, at a constant rate while driving",
          "A dragging brush or caster. The same rate at any speed and in both directions, which "
          "distinguishes it from unequal wheels. 'driving': while it goes forward or back, 'moving': in "
          "turns on the spot too.",
          {{"driving", EffectStage::body}, {"moving", EffectStage::body}},
          {{"rate",
            "rad/s",
            "turn rate added, counter-clockwise",
            -0.5,
            0.5,
            {-0.05, -0.02, -0.01, 0.01, 0.02, 0.05},
            0.0008}},
          {.reference = true, .or_gyro = true},
          [](const EffectArguments& arguments) { return std::make_unique<YawBias>(arguments); },
          true};
}

}  // namespace wheelwright::effects

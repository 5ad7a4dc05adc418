// floor_slope: speed depends on heading.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr double rolling_m_s = 0.01;  // below it the slope's pull fades: the gears hold a standing robot

class FloorSlope final : public EffectOf<FloorSlope> {
 public:
  static constexpr bool loads_motors = true;

  explicit FloorSlope(const EffectArguments& arguments)
      : along_x_(arguments.parameters[0]),
        along_y_(arguments.parameters[1]),
        seen_by_encoder_(arguments.variant == 1 || arguments.variant == 3),
        creeps_(arguments.variant == 3),
        relative_(arguments.variant == 2) {}

  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    if (!seen_by_encoder_) return;
    const double pull = along(context.pose);
    both(speed_m_s, [pull, this](double speed) { return speed + pull * (creeps_ ? 1.0 : share(speed)); });
  }
  void body(Twist& twist, const StepContext& context) override {
    if (seen_by_encoder_) return;
    const double pull = along(context.pose);
    twist.v_m_s += relative_ ? pull / default_speed_m_s * twist.v_m_s : pull * share(twist.v_m_s);
  }

 private:
  static constexpr double default_speed_m_s = 0.2;

  static double share(double speed) { return std::min(1.0, std::abs(speed) / rolling_m_s); }
  double along(const Pose& pose) const {
    return along_x_ * std::cos(pose.theta_rad) + along_y_ * std::sin(pose.theta_rad);
  }

  double along_x_;
  double along_y_;
  bool seen_by_encoder_;
  bool creeps_;
  bool relative_;
};

}  // namespace

EffectInfo floor_slope() {
  EffectInfo info{
      "floor_slope",
      "speed depends on heading",
      "Gravity along a tilted floor: faster down, slower up. Drive both ways along the same line. 'floor': "
      "the robot creeps against its wheels, 'wheel': the wheels themselves slow down and the encoders see "
      "it, 'relative': in proportion to the speed (unit: at 0.2 m/s), 'creeping': motors that let themselves "
      "be turned, so that it rolls downhill at rest, too.",
      {{"floor", EffectStage::body},
       {"wheel", EffectStage::wheel},
       {"relative", EffectStage::body},
       {"creeping", EffectStage::wheel}},
      {{"along_x", "m/s", "speed gained when heading along x", -0.15, 0.15, {0.01}},
       {"along_y", "m/s", "speed gained when heading along y", -0.15, 0.15, {0.01}}},
      {.turning = true},
      [](const EffectArguments& arguments) { return std::make_unique<FloorSlope>(arguments); }};
  info.by_pose = true;
  return info;
}

}  // namespace wheelwright::effects

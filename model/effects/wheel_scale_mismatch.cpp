// wheel_scale_mismatch: left and right wheels roll different distances for the same ticks or command.
#include <array>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

// Of the mismatch, how much is the left wheel's.
constexpr std::array share_by_variant{0.5, 1.0, 0.0};

class WheelScaleMismatch final : public EffectOf<WheelScaleMismatch> {
 public:
  explicit WheelScaleMismatch(const EffectArguments& arguments) {
    const double mismatch = arguments.parameters[0];
    const double share_of_left = share_by_variant[arguments.variant];
    gain_ = {1.0 - share_of_left * mismatch, 1.0 + (1.0 - share_of_left) * mismatch};
  }

  void floor(WheelPair& speed_m_s, const StepContext&) override {
    speed_m_s.left *= gain_.left;
    speed_m_s.right *= gain_.right;
  }
  WheelPair rolling() const override { return gain_; }

 private:
  WheelPair gain_;
};

}  // namespace

EffectInfo wheel_scale_mismatch() {
  EffectInfo info{
      "wheel_scale_mismatch",
      "left and right wheels roll different distances for the same ticks or command",
      "Wheels of different wear or tyre pressure. The encoders cannot show it: straight drives bend, "
      "forward to one side and backward to the other. 'left_wheel', 'right_wheel': one is not what the log "
      "says; else each by half, and the mean is right.",
      {{"", EffectStage::floor}, {"left_wheel", EffectStage::floor}, {"right_wheel", EffectStage::floor}},
      {{"mismatch",
        "1",
        "right minus left rolling radius, relative",
        -0.4,
        0.4,
        {-0.05, -0.02, -0.01, 0.01, 0.02, 0.05},
        0.0008}},
      {.reference = true, .or_gyro = true, .encoders = true},
      [](const EffectArguments& arguments) { return std::make_unique<WheelScaleMismatch>(arguments); }};
  info.wheel_mismatch = true;
  return info;
}

}  // namespace wheelwright::effects

// wheel_scale_mismatch: left and right wheels roll different distances for the same ticks or command.
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class WheelScaleMismatch final : public EffectOf<WheelScaleMismatch> {
 public:
  explicit WheelScaleMismatch(const EffectArguments& arguments) : mismatch_(arguments.parameters[0]) {}

  void floor(WheelPair& speed_m_s, const Surroundings&) override {
    speed_m_s.left *= 1.0 - 0.5 * mismatch_;
    speed_m_s.right *= 1.0 + 0.5 * mismatch_;
  }

 private:
  double mismatch_;
};

}  // namespace

EffectInfo wheel_scale_mismatch() {
  return {"wheel_scale_mismatch",
          "left and right wheels roll different distances for the same ticks or command",
          "Wheels of different wear or tyre pressure. The encoders cannot show it: straight drives bend, "
          "forward to "
          "one side and backward to the other.",
          {{"", EffectStage::floor}},
          {{"mismatch",
            "1",
            "right minus left rolling radius, relative",
            -0.4,
            0.4,
            {-0.05, -0.02, -0.01, 0.01, 0.02, 0.05},
            0.0008}},
          {.reference = true},
          [](const EffectArguments& arguments) { return std::make_unique<WheelScaleMismatch>(arguments); }};
}

}  // namespace wheelwright::effects

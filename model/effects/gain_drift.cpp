// gain_drift: gain drifts with time (warming up).
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class GainDrift final : public EffectOf<GainDrift> {
 public:
  explicit GainDrift(const EffectArguments& arguments)
      : change_(arguments.parameters[0]),
        time_constant_s_(arguments.parameters[1]),
        by_use_(arguments.variant == 1) {}

  void command(WheelPair& command_m_s, const StepContext& context) override {
    const double gone = -std::expm1(-context.time_s / time_constant_s_);
    command_m_s.left *= 1.0 + change_ * (by_use_ ? warmth_.left : gone);
    command_m_s.right *= 1.0 + change_ * (by_use_ ? warmth_.right : gone);
    if (by_use_) warm_up(context);
  }
  void reset() override { warmth_ = {}; }

 private:
  static constexpr double default_speed_m_s = 0.2;

  void warm_up(const StepContext& context) {
    const double share = context.period_s / (context.period_s + time_constant_s_);
    warmth_.left += share * (std::abs(context.command_m_s.left) / default_speed_m_s - warmth_.left);
    warmth_.right += share * (std::abs(context.command_m_s.right) / default_speed_m_s - warmth_.right);
  }

  double change_;
  double time_constant_s_;
  bool by_use_;
  WheelPair warmth_;
};

}  // namespace

EffectInfo gain_drift() {
  return {"gain_drift",
          "gain drifts with time (warming up)",
          "Grease that warms and thins, windings that warm and weaken; compare the same commands early and "
          "late. Counted from the start of the run; 'use': each wheel warms by what is asked of it and cools "
          "when it rests (in the long run: of driving at 0.2 m/s).",
          {{"", EffectStage::command}, {"use", EffectStage::command}},
          {{"change",
            "1",
            "relative change of the gain in the long run",
            -0.8,
            0.8,
            {-0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2},
            0.005},
           {"time_constant", "s", "of the change", 10.0, 600.0, {15.0, 40.0, 150.0}, 0.0, false}},
          {},
          [](const EffectArguments& arguments) { return std::make_unique<GainDrift>(arguments); }};
}

}  // namespace wheelwright::effects

// backlash: motion is lost on reversal.
#include <algorithm>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class Backlash final : public EffectOf<Backlash> {
 public:
  explicit Backlash(const EffectArguments& arguments)
      : gap_(arguments.parameters[0]), behind_encoder_(arguments.variant == 1) {
    Backlash::reset();
  }

  void wheel(WheelPair& speed_m_s, const Surroundings& around) override {
    if (!behind_encoder_) pass(speed_m_s, around.period_s);
  }
  void floor(WheelPair& speed_m_s, const Surroundings& around) override {
    if (behind_encoder_) pass(speed_m_s, around.period_s);
  }
  // A run begins with the teeth in contact for forward motion.
  void reset() override { in_gap_ = {gap_, gap_}; }

 private:
  void pass(WheelPair& speed_m_s, double period_s) {
    speed_m_s = {passed(in_gap_.left, speed_m_s.left, period_s),
                 passed(in_gap_.right, speed_m_s.right, period_s)};
  }
  double passed(double& in_gap, double speed_m_s, double period_s) const {
    const double at = in_gap + speed_m_s * period_s;
    in_gap = std::clamp(at, 0.0, gap_);
    return (at - in_gap) / period_s;
  }

  double gap_;
  bool behind_encoder_;
  WheelPair in_gap_;
};

}  // namespace

EffectInfo backlash() {
  return {"backlash",
          "motion is lost on reversal",
          "Play between motor and wheel: after each change of direction the motor runs a fixed distance "
          "before the "
          "wheel follows. 'wheel': the encoder sits on the wheel and sees the loss, 'floor': on the motor, "
          "and does "
          "not.",
          {{"wheel", EffectStage::wheel}, {"floor", EffectStage::floor}},
          {{"gap",
            "m",
            "distance lost at each reversal, at the wheel's rim",
            0.0,
            0.05,
            {0.0005, 0.001, 0.002, 0.004, 0.007, 0.012},
            0.0003}},
          {.reversal = true},
          [](const EffectArguments& arguments) { return std::make_unique<Backlash>(arguments); }};
}

}  // namespace wheelwright::effects

// coulomb_friction: speed loss that opposes motion, constant in size.
#include "model/effects/dry_friction.hpp"
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class CoulombFriction final : public EffectOf<CoulombFriction> {
 public:
  static constexpr bool loads_motors = true;

  explicit CoulombFriction(const EffectArguments& arguments)
      : levels_{arguments.parameters[0], arguments.parameters[0], arguments.parameters[1]} {}

  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    speed_m_s = {left_.step(speed_m_s.left, levels_, context.period_s),
                 right_.step(speed_m_s.right, levels_, context.period_s)};
  }
  void reset() override {
    left_.reset();
    right_.reset();
  }

 private:
  FrictionLevels levels_;
  DryFriction left_;
  DryFriction right_;
};

}  // namespace

EffectInfo coulomb_friction() {
  return {
      "coulomb_friction",
      "speed loss that opposes motion, constant in size",
      "Dry friction in gear and bearing. Coasting to a stop is a straight line instead of an exponential; "
      "small "
      "commands lose the most in proportion. A wheel PID hides it once settled.",
      {{"", EffectStage::wheel}},
      {{"speed_loss",
        "m/s",
        "steady speed that friction costs",
        0.0,
        0.2,
        {0.003, 0.006, 0.012, 0.025, 0.05},
        0.001},
       {"lag",
        "s",
        "with which the wheel answers to a change of friction",
        0.005,
        0.6,
        {0.06, 0.15},
        0.0,
        false}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<CoulombFriction>(arguments); }};
}

}  // namespace wheelwright::effects

// coulomb_friction: speed loss that opposes motion, constant in size.
#include "model/effects/dry_friction.hpp"
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr std::size_t controlled = 1;

class CoulombFriction final : public EffectOf<CoulombFriction> {
 public:
  static constexpr bool loads_motors = true;

  explicit CoulombFriction(const EffectArguments& arguments)
      : levels_{arguments.parameters[0], arguments.parameters[0], arguments.parameters[1]} {
    if (arguments.variant == controlled) levels_.recovery_per_s = 1.0 / arguments.parameters[2];
  }

  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    friction_.step(speed_m_s, levels_, context.period_s);
  }
  void reset() override { friction_.reset(); }

 private:
  FrictionLevels levels_;
  DryFrictionPair friction_;
};

std::vector<ParameterInfo> free_parameters() {
  return {{"speed_loss",
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
           false}};
}

std::vector<ParameterInfo> controlled_parameters() {
  std::vector<ParameterInfo> parameters = free_parameters();
  parameters[0] = {"speed_loss", "m/s", "steady speed that friction would cost without a controller",
                   0.0,          1.0,   {0.012, 0.025, 0.05, 0.1, 0.2},
                   0.002};
  parameters[1].sizes = {0.05};
  parameters.push_back(recovery_parameter({0.05, 0.15, 0.4}));
  return parameters;
}

}  // namespace

EffectInfo coulomb_friction() {
  EffectInfo info{
      "coulomb_friction",
      "speed loss that opposes motion, constant in size",
      "Dry friction in gear and bearing. Coasting to a stop is a straight line instead of an exponential; "
      "small commands lose the most in proportion. 'controlled': a controller of the wheel's speed makes up "
      "for it in a while, and the way that was lost until then, at each start and reversal, stays lost.",
      {{"", EffectStage::wheel}, {"controlled", EffectStage::wheel, controlled_parameters()}},
      free_parameters(),
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<CoulombFriction>(arguments); }};
  info.by_wheel = true;
  return info;
}

}  // namespace wheelwright::effects

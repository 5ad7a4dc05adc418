// stiction: a wheel at rest needs more to break away than to keep moving.
#include "model/effects/dry_friction.hpp"
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr std::size_t controlled_stiction = 1;

class Stiction final : public EffectOf<Stiction> {
 public:
  static constexpr bool loads_motors = true;

  explicit Stiction(const EffectArguments& arguments)
      : levels_{arguments.parameters[0] + arguments.parameters[1], arguments.parameters[1],
                arguments.parameters[2], arguments.parameters[3]} {
    if (arguments.variant == controlled_stiction) levels_.recovery_per_s = 1.0 / arguments.parameters[4];
  }

  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    friction_.step(speed_m_s, levels_, context.period_s);
  }
  void reset() override { friction_.reset(); }

 private:
  FrictionLevels levels_;
  DryFrictionPair friction_;
};

std::vector<ParameterInfo> stiction_parameters() {
  return {{"breakaway_excess",
           "m/s",
           "drive that a standing wheel needs beyond what friction costs a moving one",
           0.0,
           0.3,
           {0.01, 0.018, 0.028, 0.042, 0.06, 0.085},
           0.003},
          {"sliding", "m/s", "speed that friction costs a moving wheel", 0.0, 0.2, {0.0, 0.008}, 0.0, false},
          {"lag",
           "s",
           "with which the wheel answers to a change of friction",
           0.005,
           0.6,
           {0.03, 0.1},
           0.0,
           false},
          {"sticking_speed",
           "m/s",
           "at which friction has risen so far that a moving wheel stops (Stribeck)",
           0.0005,
           0.1,
           {0.002, 0.012},
           0.0,
           false}};
}

std::vector<ParameterInfo> controlled_stiction_parameters() {
  std::vector<ParameterInfo> parameters = stiction_parameters();
  parameters[0] = {"breakaway_excess",
                   "m/s",
                   "drive that a standing wheel needs beyond what friction takes from a moving one",
                   0.0,
                   1.0,
                   {0.02, 0.05, 0.12, 0.3},
                   0.004};
  parameters[1] = {"sliding", "m/s", "speed that friction would cost a moving wheel without a controller",
                   0.0,       1.0,   {0.0, 0.02},
                   0.0,       false};
  parameters[2].sizes = {0.05};
  parameters[3].sizes = {0.005};
  parameters.push_back(recovery_parameter({0.08, 0.3}));
  return parameters;
}

// One that needs not twice as much to break away as to keep moving has mostly dry friction.
bool sticks(const EffectArguments& friction, double /*largest_command_m_s*/) {
  return friction.parameters[0] > friction.parameters[1];
}

}  // namespace

EffectInfo stiction() {
  EffectInfo info{
      "stiction",
      "a wheel at rest needs more to break away than to keep moving",
      "Static friction above the sliding one. A slow ramp up starts late, a slow ramp down stops later: the "
      "threshold of starting lies above that of stopping, which a dead zone's does not. 'controlled': a "
      "controller of the wheel's speed drives harder the longer the wheel stands, until it breaks away.",
      {{"", EffectStage::wheel}, {"controlled", EffectStage::wheel, controlled_stiction_parameters()}},
      stiction_parameters(),
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<Stiction>(arguments); }};
  info.in_character = sticks;
  return info;
}

}  // namespace wheelwright::effects

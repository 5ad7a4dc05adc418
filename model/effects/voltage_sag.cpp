// voltage_sag: gain follows the battery voltage.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr double nominal_v = 14.4;  // its choice only moves gain between this effect and the linear part

class VoltageSag final : public EffectOf<VoltageSag> {
 public:
  explicit VoltageSag(const EffectArguments& arguments) : exponent_(arguments.parameters[0]) {}

  void command(WheelPair& command_m_s, const StepContext& context) override {
    if (!(context.battery_v > 0.0)) return;
    if (context.battery_v != last_v_) {
      last_v_ = context.battery_v;
      gain_ = std::pow(context.battery_v / nominal_v, exponent_);
    }
    both(command_m_s, [this](double u) { return gain_ * u; });
  }
  void reset() override {
    last_v_ = nominal_v;
    gain_ = 1.0;
  }

 private:
  double exponent_;
  double last_v_ = nominal_v;
  double gain_ = 1.0;
};

}  // namespace

EffectInfo voltage_sag() {
  return {"voltage_sag",
          "gain follows the battery voltage",
          "Without a speed loop a motor's speed follows its supply. The voltage has to be in the log: "
          "without it, it "
          "looks like drift with time.",
          {{"", EffectStage::command}},
          {{"exponent",
            "1",
            "gain is (voltage / 14.4 V) to this power; 1: in proportion",
            -1.0,
            4.0,
            {0.25, 0.5, 1.0, 2.0}}},
          {.battery = true},
          [](const EffectArguments& arguments) { return std::make_unique<VoltageSag>(arguments); }};
}

}  // namespace wheelwright::effects

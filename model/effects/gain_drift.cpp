// gain_drift: gain drifts with time (warming up).
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class GainDrift final : public EffectOf<GainDrift> {
 public:
  explicit GainDrift(const EffectArguments& arguments)
      : change_(arguments.parameters[0]), time_constant_s_(arguments.parameters[1]) {}

  void command(WheelPair& command_m_s, const Surroundings& around) override {
    const double gain = 1.0 - change_ * std::expm1(-around.time_s / time_constant_s_);
    both(command_m_s, [gain](double u) { return gain * u; });
  }

 private:
  double change_;
  double time_constant_s_;
};

}  // namespace

EffectInfo gain_drift() {
  return {"gain_drift",
          "gain drifts with time (warming up)",
          "Grease that warms and thins, windings that warm and weaken. Counted from the start of the run; "
          "compare "
          "the same commands early and late.",
          {{"", EffectStage::command}},
          {{"change",
            "1",
            "relative change of the gain in the long run",
            -0.8,
            0.8,
            {-0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2},
            0.005},
           {"time_constant", "s", "of the change", 3.0, 600.0, {15.0, 40.0, 150.0}, 0.0, false}},
          {},
          [](const EffectArguments& arguments) { return std::make_unique<GainDrift>(arguments); }};
}

}  // namespace wheelwright::effects

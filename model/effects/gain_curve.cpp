// gain_curve: gain bends with command size.
#include "model/effects/effect.hpp"
#include "model/effects/odd_bend.hpp"

namespace wheelwright::effects {
namespace {

class GainCurve final : public EffectOf<GainCurve> {
 public:
  explicit GainCurve(const EffectArguments& arguments)
      : bend_(arguments.parameters[0], arguments.parameters[1] / default_command_m_s, min_top_m_s),
        of_command_(arguments.variant == 0) {}

  void command(WheelPair& command_m_s, const StepContext&) override {
    if (of_command_) both(command_m_s, bend_);
  }
  void wheel(WheelPair& speed_m_s, const StepContext&) override {
    if (!of_command_) both(speed_m_s, bend_);
  }

 private:
  static constexpr double default_command_m_s = 0.3;  // gives both parameters the same unit
  static constexpr double min_top_m_s = 0.35;         // what is level below that is a saturation

  OddBend bend_;
  bool of_command_;
};

}  // namespace

EffectInfo gain_curve() {
  return {"gain_curve",
          "gain bends with command size",
          "Motor drivers and firmware tables that give less (or more) for large commands in proportion. "
          "'command': of the motor's command, 'speed': of what the wheel does, behind its lag.",
          {{"command", EffectStage::command}, {"speed", EffectStage::wheel}},
          {{"curvature", "s/m", "relative loss of gain per m/s of command", -3.0, 3.0, {0.1}},
           {"cubic",
            "s/m",
            "further loss that grows with the square of the command, by as much at 0.3 m/s",
            -3.0,
            3.0,
            {0.1}}},
          {.variety = true},
          [](const EffectArguments& arguments) { return std::make_unique<GainCurve>(arguments); }};
}

}  // namespace wheelwright::effects

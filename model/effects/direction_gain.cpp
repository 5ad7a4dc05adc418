// direction_gain: forward and reverse gains differ.
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class DirectionGain final : public EffectOf<DirectionGain> {
 public:
  explicit DirectionGain(const EffectArguments& arguments) : change_(arguments.parameters[0]) {}

  void command(WheelPair& command_m_s, const Surroundings&) override {
    both(command_m_s, [this](double u) { return u < 0.0 ? u * (1.0 + change_) : u; });
  }

 private:
  double change_;
};

}  // namespace

EffectInfo direction_gain() {
  return {"direction_gain",
          "forward and reverse gains differ",
          "Brush timing of the motors, or gears that run harder one way.",
          {{"", EffectStage::command}},
          {{"reverse_change",
            "1",
            "relative change of the gain in reverse",
            -0.7,
            0.7,
            {-0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2},
            0.004}},
          {.reversal = true},
          [](const EffectArguments& arguments) { return std::make_unique<DirectionGain>(arguments); }};
}

}  // namespace wheelwright::effects

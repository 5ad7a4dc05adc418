// direction_gain: forward and reverse gains differ.
#include <utility>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class DirectionGain final : public EffectOf<DirectionGain> {
 public:
  explicit DirectionGain(const EffectArguments& arguments)
      : change_{arguments.parameters.front(), arguments.parameters.back()} {}

  void command(WheelPair& command_m_s, const StepContext&) override {
    if (command_m_s.left < 0.0) command_m_s.left *= 1.0 + change_.left;
    if (command_m_s.right < 0.0) command_m_s.right *= 1.0 + change_.right;
  }

 private:
  WheelPair change_;  // relative, of the gain in reverse
};

ParameterInfo change_of(const std::string& name, const std::string& meaning, std::vector<double> sizes) {
  return {name, "1", meaning, -0.7, 0.7, std::move(sizes), 0.004};
}

}  // namespace

EffectInfo direction_gain() {
  return {
      "direction_gain",
      "forward and reverse gains differ",
      "Brush timing of the motors, or gears that run harder one way. 'each_wheel': not alike; of motors that "
      "are mounted as in a mirror, one is stronger forward and the other in reverse.",
      {{"", EffectStage::command},
       {"each_wheel",
        EffectStage::command,
        {change_of("reverse_change_left", "relative change of the left wheel's gain in reverse", {0.05}),
         change_of("reverse_change_right", "the same of the right wheel's", {0.05})}}},
      {change_of("reverse_change", "relative change of the gain in reverse",
                 {-0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2})},
      {.reversal = true},
      [](const EffectArguments& arguments) { return std::make_unique<DirectionGain>(arguments); }};
}

}  // namespace wheelwright::effects

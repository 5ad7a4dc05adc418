// dead_zone: commands below a threshold move nothing.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class DeadZone final : public EffectOf<DeadZone> {
 public:
  explicit DeadZone(const EffectArguments& arguments)
      : threshold_(arguments.parameters[0]), lost_above_(arguments.variant == 1 ? threshold_ : 0.0) {}

  void command(WheelPair& command_m_s, const Surroundings&) override {
    both(command_m_s, [this](double u) {
      return std::abs(u) < threshold_ ? 0.0 : std::copysign(std::abs(u) - lost_above_, u);
    });
  }

 private:
  double threshold_;
  double lost_above_;
};

}  // namespace

EffectInfo dead_zone() {
  return {
      "dead_zone",
      "commands below a threshold move nothing",
      "Firmware or motor driver ignores small commands; a static map, the same for starting and stopping. "
      "'cut' passes larger commands whole, 'offset' takes the threshold from them.",
      {{"cut", EffectStage::command}, {"offset", EffectStage::command}},
      {{"threshold",
        "m/s",
        "commands below it do nothing",
        0.0,
        0.3,
        {0.01, 0.02, 0.03, 0.045, 0.06, 0.08, 0.11},
        0.002}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<DeadZone>(arguments); }};
}

}  // namespace wheelwright::effects

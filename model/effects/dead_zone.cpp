// dead_zone: commands below a threshold move nothing.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class DeadZone final : public EffectOf<DeadZone> {
 public:
  explicit DeadZone(const EffectArguments& arguments)
      : threshold_(arguments.parameters[0]), taper_(arguments.parameters[1]) {}

  void command(WheelPair& command_m_s, const StepContext&) override {
    both(command_m_s, [this](double u) {
      const double above = std::max(0.0, std::abs(u) - threshold_);
      return std::copysign(std::min(std::abs(u), above / taper_), u);
    });
  }

 private:
  double threshold_;
  double taper_;
};

}  // namespace

EffectInfo dead_zone() {
  EffectInfo info{
      "dead_zone",
      "commands below a threshold move nothing",
      "Firmware or motor driver ignores small commands; a static map, the same for starting and stopping. "
      "Firmware passes larger commands whole, an output stage gives back what it takes within a range above "
      "the threshold, or never.",
      {{"", EffectStage::command}},
      {{"threshold",
        "m/s",
        "commands below it do nothing",
        0.0,
        0.3,
        {0.01, 0.02, 0.03, 0.045, 0.06, 0.08, 0.11},
        0.002},
       {"taper",
        "1",
        "how slowly larger commands come through again: 1, the threshold is taken from each; less, from "
        "those "
        "below threshold / (1 - taper)",
        0.002,
        1.0,
        {0.002, 0.4, 1.0},
        0.0,
        false}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<DeadZone>(arguments); }};
  info.by_wheel = true;
  return info;
}

}  // namespace wheelwright::effects

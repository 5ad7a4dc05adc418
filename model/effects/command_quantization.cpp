// command_quantization: commands act in steps.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class CommandQuantization final : public EffectOf<CommandQuantization> {
 public:
  explicit CommandQuantization(const EffectArguments& arguments)
      : step_(arguments.parameters[0]), toward_zero_(arguments.variant == 1) {}

  void command(WheelPair& command_m_s, const Surroundings&) override {
    if (step_ <= 0.0) return;
    both(command_m_s, [this](double u) {
      return step_ * (toward_zero_ ? std::trunc(u / step_ + std::copysign(1e-9, u)) : std::round(u / step_));
    });
  }

 private:
  double step_;
  bool toward_zero_;
};

// A wrong step rounds other commands up than the right one: the search has to begin near it. Spaced so that a
// command of 0.4 m/s is rounded the same way as by the step between two of them.
std::vector<double> steps_to_try() {
  std::vector<double> steps;
  for (double per_m_s = 170.0; per_m_s > 9.0; per_m_s -= 1.25) steps.push_back(1.0 / per_m_s);
  return steps;
}

}  // namespace

EffectInfo command_quantization() {
  return {
      "command_quantization",
      "commands act in steps",
      "The motor controller works in coarse units, e.g. whole encoder ticks per control period (28.5 mm/s on "
      "some Roombas). 'nearest' rounds, 'toward_zero' cuts off.",
      {{"nearest", EffectStage::command}, {"toward_zero", EffectStage::command}},
      {{"step", "m/s", "distance of the speeds that can be had", 0.0, 0.2, steps_to_try(), 0.002}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<CommandQuantization>(arguments); }};
}

}  // namespace wheelwright::effects

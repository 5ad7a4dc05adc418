// command_quantization: commands act in steps.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class CommandQuantization final : public EffectOf<CommandQuantization> {
 public:
  explicit CommandQuantization(const EffectArguments& arguments)
      : step_(arguments.parameters[0]), rises_at_(arguments.parameters[1]) {}

  void command(WheelPair& command_m_s, const StepContext&) override {
    if (step_ <= 0.0) return;
    both(command_m_s, [this](double u) {
      constexpr double rounding_error = 1e-9;
      return std::copysign(step_ * std::floor(std::abs(u) / step_ + 1.0 - rises_at_ + rounding_error), u);
    });
  }

 private:
  double step_;
  double rises_at_;
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
      "some Roombas). It may round them (rises_at 0.5), cut them off (1), or anything else.",
      {{"", EffectStage::command, {}, true}},
      {{"step", "m/s", "distance of the speeds that can be had", 0.0, 0.5, steps_to_try(), 0.002},
       {"rises_at",
        "1",
        "share of a step from which a command goes up to the next one",
        0.0,
        1.0,
        {0.5, 1.0},
        0.0,
        false}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<CommandQuantization>(arguments); }};
}

}  // namespace wheelwright::effects

// rate_limit: change of wheel speed is limited.
#include <algorithm>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class RateLimit final : public EffectOf<RateLimit> {
 public:
  explicit RateLimit(const EffectArguments& arguments)
      : limit_(arguments.parameters[0]), of_command_(arguments.variant == 0) {}

  void command(WheelPair& command_m_s, const Surroundings& around) override {
    if (of_command_) follow(command_m_s, around.period_s);
  }
  void wheel(WheelPair& speed_m_s, const Surroundings& around) override {
    if (!of_command_) follow(speed_m_s, around.period_s);
  }
  void reset() override { now_ = {}; }

 private:
  void follow(WheelPair& wanted, double period_s) {
    const double step = limit_ * period_s;
    now_.left += std::clamp(wanted.left - now_.left, -step, step);
    now_.right += std::clamp(wanted.right - now_.right, -step, step);
    wanted = now_;
  }

  double limit_;
  bool of_command_;
  WheelPair now_;
};

}  // namespace

EffectInfo rate_limit() {
  return {"rate_limit",
          "change of wheel speed is limited",
          "A ramp in the firmware or a limit of motor current: large steps take longer in proportion, small "
          "ones do "
          "not, which no linear lag does.",
          {{"command", EffectStage::command}, {"speed", EffectStage::wheel}},
          {{"limit",
            "m/s^2",
            "largest change of a wheel's speed",
            0.02,
            50.0,
            {4.0, 2.5, 1.6, 1.0, 0.7, 0.5, 0.35, 0.25, 0.15}}},
          {.variety = true},
          [](const EffectArguments& arguments) { return std::make_unique<RateLimit>(arguments); }};
}

}  // namespace wheelwright::effects

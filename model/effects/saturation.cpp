// saturation: wheel speed is limited.
#include <algorithm>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class Saturation final : public EffectOf<Saturation> {
 public:
  explicit Saturation(const EffectArguments& arguments)
      : limit_(arguments.parameters[0]),
        motor_lag_s_(arguments.parameters[1]),
        of_command_(arguments.variant == 0) {}

  void command(WheelPair& command_m_s, const Surroundings& around) override {
    if (of_command_) limit(command_m_s, around.period_s);
  }
  void wheel(WheelPair& speed_m_s, const Surroundings& around) override {
    if (!of_command_) limit(speed_m_s, around.period_s);
  }
  void reset() override { now_ = {}; }

 private:
  void limit(WheelPair& wanted, double period_s) {
    const double share = period_s / (period_s + motor_lag_s_);
    const auto follow = [&](double& now, double to) {
      now += std::clamp(to - now, share * (-limit_ - now), share * (limit_ - now));
    };
    follow(now_.left, wanted.left);
    follow(now_.right, wanted.right);
    wanted = now_;
  }

  double limit_;
  double motor_lag_s_;
  bool of_command_;
  WheelPair now_;
};

}  // namespace

EffectInfo saturation() {
  return {
      "saturation",
      "wheel speed is limited",
      "Supply voltage or firmware cap. 'command': the drive is limited before the motor answers, 'speed': "
      "the wheel itself cannot be faster. A controller that is short of voltage is short of acceleration "
      "too: "
      "the closer to the limit, the less.",
      {{"command", EffectStage::command}, {"speed", EffectStage::wheel}},
      {{"limit", "m/s", "largest speed of a wheel", 0.005, 5.0, {0.5, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15, 0.1}},
       {"motor_lag",
        "s",
        "time constant of the motor at its full voltage; 0: it is there at once",
        0.0,
        1.0,
        {0.0, 0.06},
        0.0,
        false}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<Saturation>(arguments); }};
}

}  // namespace wheelwright::effects

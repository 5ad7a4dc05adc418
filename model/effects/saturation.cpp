// saturation: wheel speed is limited.
#include <algorithm>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class Saturation final : public EffectOf<Saturation> {
 public:
  explicit Saturation(const EffectArguments& arguments)
      : limit_(arguments.parameters[0]), of_command_(arguments.variant == 0) {}

  void command(WheelPair& command_m_s, const Surroundings&) override {
    if (of_command_) limit(command_m_s);
  }
  void wheel(WheelPair& speed_m_s, const Surroundings&) override {
    if (!of_command_) limit(speed_m_s);
  }

 private:
  void limit(WheelPair& pair) const {
    both(pair, [this](double value) { return std::clamp(value, -limit_, limit_); });
  }

  double limit_;
  bool of_command_;
};

}  // namespace

EffectInfo saturation() {
  return {
      "saturation",
      "wheel speed is limited",
      "Supply voltage or firmware cap. 'command': the drive is limited before the motor answers, 'speed': "
      "the "
      "wheel itself cannot be faster.",
      {{"command", EffectStage::command}, {"speed", EffectStage::wheel}},
      {{"limit", "m/s", "largest speed of a wheel", 0.005, 5.0, {0.5, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15, 0.1}}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<Saturation>(arguments); }};
}

}  // namespace wheelwright::effects

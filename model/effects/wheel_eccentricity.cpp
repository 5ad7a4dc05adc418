// wheel_eccentricity: speed ripples once per wheel turn.
#include <cmath>
#include <numbers>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class WheelEccentricity final : public EffectOf<WheelEccentricity> {
 public:
  explicit WheelEccentricity(const EffectArguments& arguments)
      : left_sine_(arguments.parameters[0]),
        left_cosine_(arguments.parameters[1]),
        right_sine_(arguments.parameters[2]),
        right_cosine_(arguments.parameters[3]),
        per_metre_(2.0 * std::numbers::pi / arguments.parameters[4]),
        behind_encoder_(arguments.variant == 0) {}

  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    if (!behind_encoder_) ripple(speed_m_s, context);
  }
  void floor(WheelPair& speed_m_s, const StepContext& context) override {
    if (behind_encoder_) ripple(speed_m_s, context);
  }

 private:
  void ripple(WheelPair& speed_m_s, const StepContext& context) const {
    const double left = per_metre_ * (context.distance_m.left + 0.5 * speed_m_s.left * context.period_s);
    const double right = per_metre_ * (context.distance_m.right + 0.5 * speed_m_s.right * context.period_s);
    speed_m_s.left *= 1.0 + left_sine_ * std::sin(left) + left_cosine_ * std::cos(left);
    speed_m_s.right *= 1.0 + right_sine_ * std::sin(right) + right_cosine_ * std::cos(right);
  }

  double left_sine_;
  double left_cosine_;
  double right_sine_;
  double right_cosine_;
  double per_metre_;
  bool behind_encoder_;
};

ParameterInfo ripple(const std::string& name, const std::string& meaning) {
  return {name, "1", meaning, -0.4, 0.4, {0.03}};
}

}  // namespace

EffectInfo wheel_eccentricity() {
  EffectInfo info{
      "wheel_eccentricity",
      "speed ripples once per wheel turn",
      "A wheel that is mounted off its centre or is not round. The wheel's angle is counted from the start "
      "of "
      "the run, unless the runs show that the wheels began at angles of their own. 'floor': the wheel's "
      "radius changes, which its encoder does not see; 'wheel': the "
      "encoder sees it.",
      {{"floor", EffectStage::floor}, {"wheel", EffectStage::wheel}},
      {ripple("left_sine", "relative ripple of the left wheel, in sine of its angle"),
       ripple("left_cosine", "in cosine"),
       ripple("right_sine", "relative ripple of the right wheel, in sine of its angle"),
       ripple("right_cosine", "in cosine"),
       {"circumference", "m", "of a wheel", 0.05, 2.0, {0.2042, 0.2199, 0.2262, 0.2356, 0.251}, 0.0, false}},
      {},
      [](const EffectArguments& arguments) { return std::make_unique<WheelEccentricity>(arguments); }};
  info.by_wheel_angle = true;
  return info;
}

}  // namespace wheelwright::effects

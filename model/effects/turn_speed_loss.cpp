// turn_speed_loss: forward speed is lost while turning, in proportion to the size of the turn rate.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class TurnSpeedLoss final : public EffectOf<TurnSpeedLoss> {
 public:
  explicit TurnSpeedLoss(const EffectArguments& arguments)
      : loss_(arguments.parameters[0]),
        onset_per_m_(arguments.parameters[1]),
        absolute_(arguments.variant == 1) {}

  void body(Twist& twist, const StepContext&) override {
    const double beyond_onset = std::abs(twist.w_rad_s) - onset_per_m_ * std::abs(twist.v_m_s);
    const double lost = loss_ * std::max(0.0, beyond_onset);
    if (absolute_) {
      twist.v_m_s =
          std::copysign(std::max(0.0, std::abs(twist.v_m_s) - default_speed_m_s * lost), twist.v_m_s);
    } else {
      twist.v_m_s *= 1.0 - std::min(lost, 1.0);
    }
  }

 private:
  static constexpr double default_speed_m_s = 0.2;  // gives both variants the same unit

  double loss_;
  double onset_per_m_;
  bool absolute_;
};

}  // namespace

EffectInfo turn_speed_loss() {
  return {
      "turn_speed_loss",
      "forward speed is lost while turning, in proportion to the size of the turn rate",
      "Casters and tyres drag sideways in a curve, or a drive slows its outer wheel where the inner one can "
      "not keep up: then only beyond some curvature. 'relative': a share of the speed; 'absolute': the same "
      "at any speed (unit: share of 0.2 m/s).",
      {{"relative", EffectStage::body}, {"absolute", EffectStage::body}},
      {{"loss",
        "s/rad",
        "share of the speed lost per rad/s",
        0.0,
        1.0,
        {0.02, 0.05, 0.1, 0.2, 0.4, 0.8},
        0.003},
       {"onset", "1/m", "no speed is lost in curves less sharp", 0.0, 10.0, {0.0, 2.0}, 0.0, false}},
      {.reference = true, .place = true, .turning = true},
      [](const EffectArguments& arguments) { return std::make_unique<TurnSpeedLoss>(arguments); },
      true};
}

}  // namespace wheelwright::effects

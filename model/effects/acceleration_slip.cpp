// acceleration_slip: distance is lost when speeding up or slowing down hard.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class AccelerationSlip final : public EffectOf<AccelerationSlip> {
 public:
  explicit AccelerationSlip(const EffectArguments& arguments)
      : slip_(arguments.parameters[0]),
        grip_m_s2_(arguments.parameters[1]),
        absolute_(arguments.variant == 1) {}

  void floor(WheelPair& speed_m_s, const Surroundings& around) override {
    const WheelPair& before = around.speed_m_s;
    const WheelPair& now = around.next_speed_m_s;
    speed_m_s.left = rolled(speed_m_s.left, (now.left - before.left) / around.period_s);
    speed_m_s.right = rolled(speed_m_s.right, (now.right - before.right) / around.period_s);
  }

 private:
  static constexpr double usual_speed_m_s = 0.2;  // gives both variants the same unit

  double rolled(double speed, double acceleration) const {
    const double lost = slip_ * std::max(0.0, std::abs(acceleration) - grip_m_s2_);
    if (!absolute_) return speed * (1.0 - std::min(lost, 1.0));
    const double left = std::max(0.0, std::abs(speed) - lost * usual_speed_m_s);
    return std::copysign(left, speed);
  }

  double slip_;
  double grip_m_s2_;
  bool absolute_;
};

}  // namespace

EffectInfo acceleration_slip() {
  return {"acceleration_slip",
          "distance is lost when speeding up or slowing down hard",
          "The tyre slips in proportion to what acceleration asks of it beyond its grip. Encoders count what "
          "the floor "
          "does not give. 'relative': a share of the speed; 'absolute': the same at any speed (unit: share "
          "of 0.2 m/s).",
          {{"relative", EffectStage::floor}, {"absolute", EffectStage::floor}},
          {{"slip",
            "s^2/m",
            "share of the speed lost per m/s^2 beyond the grip",
            0.0,
            3.0,
            {0.03, 0.08, 0.2, 0.5},
            0.003},
           {"grip", "m/s^2", "acceleration without slip", 0.0, 5.0, {0.0, 0.3, 0.7}, 0.0, false}},
          {.reference = true},
          [](const EffectArguments& arguments) { return std::make_unique<AccelerationSlip>(arguments); }};
}

}  // namespace wheelwright::effects

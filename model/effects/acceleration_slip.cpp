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
        way_(static_cast<Way>(arguments.variant)) {}

  void floor(WheelPair& speed_m_s, const StepContext& context) override {
    const WheelPair& before = context.speed_m_s;
    const WheelPair& now = context.next_speed_m_s;
    if (way_ == Way::sliding) {
      speed_m_s = {dragged_along(floor_.left, speed_m_s.left, context.period_s),
                   dragged_along(floor_.right, speed_m_s.right, context.period_s)};
      return;
    }
    speed_m_s.left = rolled(speed_m_s.left, (now.left - before.left) / context.period_s);
    speed_m_s.right = rolled(speed_m_s.right, (now.right - before.right) / context.period_s);
  }
  void reset() override { floor_ = {}; }

 private:
  enum class Way { relative, absolute, sliding };
  struct Contact {
    double speed_m_s = 0.0;
    bool slides = false;
  };
  static constexpr double default_speed_m_s = 0.2;  // gives the variants the same unit
  static constexpr double stiffest = 1e-3;          // s^2/m: as good as no slip

  double rolled(double speed, double acceleration) const {
    const double lost = slip_ * std::max(0.0, std::abs(acceleration) - grip_m_s2_);
    if (way_ == Way::relative) return speed * (1.0 - std::min(lost, 1.0));
    const double left = std::max(0.0, std::abs(speed) - lost * default_speed_m_s);
    return std::copysign(left, speed);
  }

  // The tyre holds up to its grip; once it slides, the floor gives 1 / slip, until both are as fast again.
  double dragged_along(Contact& floor, double wheel_m_s, double period_s) const {
    const double wanted = (wheel_m_s - floor.speed_m_s) / period_s;
    const double sliding = 1.0 / std::max(slip_, stiffest);
    const double given = floor.slides ? sliding : std::max(grip_m_s2_, sliding);
    floor.slides = std::abs(wanted) > given;
    floor.speed_m_s = floor.slides ? floor.speed_m_s + std::copysign(sliding, wanted) * period_s : wheel_m_s;
    return floor.speed_m_s;
  }

  double slip_;
  double grip_m_s2_;
  Way way_;
  struct {
    Contact left;
    Contact right;
  } floor_;
};

}  // namespace

EffectInfo acceleration_slip() {
  return {
      "acceleration_slip",
      "distance is lost when speeding up or slowing down hard",
      "The tyre slips in proportion to what acceleration asks of it beyond its grip. Encoders count what "
      "the floor does not give. 'relative': a share of the speed; 'absolute': the same at any speed "
      "(unit: share of 0.2 m/s); 'sliding': beyond its grip it slides, and the robot speeds up and slows "
      "down by no more than 1 / slip until it has caught up.",
      {{"relative", EffectStage::floor}, {"absolute", EffectStage::floor}, {"sliding", EffectStage::floor}},
      {{"slip",
        "s^2/m",
        "share of the speed lost per m/s^2 beyond the grip",
        0.0,
        3.0,
        {0.03, 0.08, 0.2, 0.5, 1.0, 1.6},
        0.003},
       {"grip", "m/s^2", "acceleration without slip", 0.0, 5.0, {0.0, 0.3, 0.7}, 0.0, false}},
      {.reference = true},
      [](const EffectArguments& arguments) { return std::make_unique<AccelerationSlip>(arguments); }};
}

}  // namespace wheelwright::effects

// backlash: motion is lost on reversal.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class Backlash final : public EffectOf<Backlash> {
 public:
  explicit Backlash(const EffectArguments& arguments)
      : gap_(arguments.parameters[0]),
        damping_per_s_(arguments.parameters[1]),
        start_m_(arguments.parameters[2] * gap_),
        place_(static_cast<Place>(arguments.variant)) {
    Backlash::reset();
  }

  void command(WheelPair& command_m_s, const StepContext& context) override {
    if (place_ == Place::before_response) pass(command_m_s, context.period_s);
  }
  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    if (place_ == Place::before_encoder) pass(speed_m_s, context.period_s);
  }
  void floor(WheelPair& speed_m_s, const StepContext& context) override {
    if (place_ == Place::behind_encoder) pass(speed_m_s, context.period_s);
  }
  void reset() override { left_ = right_ = {start_m_, 0.0}; }

 private:
  enum class Place { before_encoder, behind_encoder, before_response };  // as the variants are listed

  struct Wheel {
    double in_gap_m = 0.0;  // from the teeth that drive backward to those that drive forward
    double speed_m_s = 0.0;
  };

  void pass(WheelPair& speed_m_s, double period_s) {
    speed_m_s = {passed(left_, speed_m_s.left, period_s), passed(right_, speed_m_s.right, period_s)};
  }
  // Between the teeth the wheel runs on by itself, slower and slower, and may reach the other side.
  double passed(Wheel& wheel, double motor_m_s, double period_s) const {
    const double by_itself = wheel.speed_m_s * std::exp(-damping_per_s_ * period_s);
    const double at = wheel.in_gap_m + (motor_m_s - by_itself) * period_s;
    wheel.in_gap_m = std::clamp(at, 0.0, gap_);
    const double travelled_m = (at - wheel.in_gap_m) + by_itself * period_s;
    const bool touches = at != wheel.in_gap_m;
    wheel.speed_m_s = touches ? motor_m_s : by_itself;
    return travelled_m / period_s;
  }

  double gap_;
  double damping_per_s_;
  double start_m_;
  Place place_;
  Wheel left_;
  Wheel right_;
};

}  // namespace

EffectInfo backlash() {
  EffectInfo info{
      "backlash",
      "motion is lost on reversal",
      "Play between motor and wheel: after each change of direction the motor runs a fixed distance "
      "before the wheel follows. A wheel that little brakes crosses the gap while it slows down, and the "
      "loss comes when the motor speeds up again. 'wheel': the motor answers slowly, and wheel and robot "
      "follow it at once; the encoder sits on the wheel and sees the loss. 'floor': the same, but the "
      "encoder sits on the motor and does not see it. 'command': a light motor crosses the gap at once, "
      "and the mass of the robot behind it answers slowly.",
      {{"wheel", EffectStage::wheel}, {"floor", EffectStage::floor}, {"command", EffectStage::command}},
      {{"gap",
        "m",
        "distance lost at each reversal, at the wheel's rim",
        0.0,
        0.05,
        {0.0005, 0.001, 0.002, 0.004, 0.007, 0.012},
        0.0003},
       {"damping",
        "1/s",
        "rate at which a wheel that no tooth touches loses its speed",
        0.0,
        300.0,
        {0.5, 2.0, 6.0, 25.0, 300.0},
        0.0,
        false},
       {"start",
        "1",
        "where in the gap runs begin, from its middle to 1, the teeth in contact for forward motion",
        0.5,
        1.0,
        {0.5},
        0.0,
        false}},
      {.reversal = true},
      [](const EffectArguments& arguments) { return std::make_unique<Backlash>(arguments); }};
  info.by_wheel = true;
  return info;
}

}  // namespace wheelwright::effects

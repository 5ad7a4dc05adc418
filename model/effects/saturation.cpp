// saturation: wheel speed is limited.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class Saturation final : public EffectOf<Saturation> {
 public:
  explicit Saturation(const EffectArguments& arguments)
      : limit_(arguments.parameters[0]),
        motor_lag_s_(arguments.parameters[1]),
        knee_(arguments.parameters[2]),
        far_below_(std::exp(-16.0 * knee_)),  // there the knee takes less than 1e-7
        of_command_(arguments.variant == 0) {}

  void command(WheelPair& command_m_s, const StepContext& context) override {
    if (of_command_) limit(command_m_s, context.period_s);
  }
  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    if (!of_command_) limit(speed_m_s, context.period_s);
  }
  void reset() override { now_ = {}; }

 private:
  // The drive that it takes to be there in time, as far as there is so much.
  void limit(WheelPair& wanted, double period_s) {
    const double share = period_s / (period_s + motor_lag_s_);
    const auto follow = [&](double& now, double to) {
      now += share * (below_limit(now + (to - now) / share) - now);
    };
    follow(now_.left, wanted.left);
    follow(now_.right, wanted.right);
    wanted = now_;
  }

  double below_limit(double drive) const {
    if (knee_ < sharp) return std::clamp(drive, -limit_, limit_);
    const double ratio = std::abs(drive) / limit_;
    if (ratio < far_below_) return drive;
    return drive * std::pow(1.0 + std::pow(ratio, 1.0 / knee_), -knee_);
  }

  static constexpr double sharp = 0.02;

  double limit_;
  double motor_lag_s_;
  double knee_;
  double far_below_;
  bool of_command_;
  WheelPair now_;
};

// Of what a command gains by a little more of it, so much is left at this size.
double slope_at(const EffectArguments& limit, double command_m_s) {
  const double knee = limit.parameters[2];
  return std::pow(1.0 + std::pow(command_m_s / limit.parameters[0], 1.0 / knee), -knee - 1.0);
}

// A limit far above all commands limits no speed; what its lag does then is a limit of acceleration. One with
// a wide knee, of which the largest command has not come to the level part, is a bend of the gain.
bool is_reached(const EffectArguments& limit, double largest_command_m_s) {
  constexpr double wide = 0.25;
  constexpr double level = 0.33;
  if (limit.parameters[0] > 2.0 * largest_command_m_s) return false;
  return limit.parameters[2] < wide || slope_at(limit, largest_command_m_s) < level;
}

}  // namespace

EffectInfo saturation() {
  EffectInfo info{
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
        false},
       {"knee",
        "1",
        "how round the way into the limit is: at the limit's own command, the speed lacks about 0.7 times "
        "this",
        0.0,
        0.5,
        {0.05},
        0.0,
        false}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<Saturation>(arguments); }};
  info.by_wheel = true;
  info.in_character = is_reached;
  return info;
}

}  // namespace wheelwright::effects

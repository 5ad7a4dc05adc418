// rate_limit: change of wheel speed is limited.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr std::size_t speed_limit = 1;
constexpr std::size_t ramp = 2;

class RateLimit final : public EffectOf<RateLimit> {
 public:
  explicit RateLimit(const EffectArguments& arguments)
      : limit_(arguments.parameters[0]), drag_per_s_(arguments.parameters[1]), variant_(arguments.variant) {}

  void command(WheelPair& command_m_s, const StepContext& context) override {
    if (variant_ != speed_limit) follow(command_m_s, context.period_s);
  }
  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    if (variant_ == speed_limit) follow(speed_m_s, context.period_s);
  }
  void reset() override { now_ = {}; }

 private:
  // What drags on the wheel takes a part of the drive that is left to speed it up, and helps to slow it down.
  void follow(WheelPair& wanted, double period_s) {
    follow_one(now_.left, wanted.left, period_s);
    follow_one(now_.right, wanted.right, period_s);
  }

  // A ramp that goes on all the time brings the mean of where it begins and where it ends, and stays there
  // for the rest of a period in which it arrives.
  void follow_one(double& now, double& wanted, double period_s) const {
    const double upwards = std::max(0.0, limit_ - drag_per_s_ * now);
    const double downwards = std::max(0.0, limit_ + drag_per_s_ * now);
    const double before = now;
    const double most = period_s * (wanted > now ? upwards : downwards);
    now += std::clamp(wanted - now, -most, most);
    const double change = now - before;
    const double ramping = most > 0.0 ? std::abs(change) / most : 0.0;  // share of the period
    wanted = variant_ == ramp ? now - 0.5 * ramping * change : now;
  }

  double limit_;
  double drag_per_s_;
  std::size_t variant_;
  WheelPair now_;
};

// Where drag leaves nothing of it at speeds that are asked for, what is limited is speed: saturation.
bool leaves_speed_free(const EffectArguments& limit, double largest_command_m_s) {
  constexpr double a_tenth_more = 1.1;  // than any command
  return limit.parameters[0] > limit.parameters[1] * a_tenth_more * largest_command_m_s;
}

}  // namespace

EffectInfo rate_limit() {
  EffectInfo info{
      "rate_limit",
      "change of wheel speed is limited",
      "A ramp in the firmware or a limit of motor current: large steps take longer in proportion, small "
      "ones do not, which no linear lag does. 'command': of what is wanted, once a period; 'ramp': likewise, "
      "many times a period; 'speed': of the wheel.",
      {{"command", EffectStage::command}, {"speed", EffectStage::wheel}, {"ramp", EffectStage::command}},
      {{"limit",
        "m/s^2",
        "largest change of a wheel's speed",
        0.02,
        50.0,
        {4.0, 2.5, 1.6, 1.0, 0.7, 0.5, 0.35, 0.25, 0.15}},
       {"drag",
        "1/s",
        "by so much less the faster the wheel is, in braking more",
        0.0,
        20.0,
        {0.0, 2.0},
        0.0,
        false}},
      {.variety = true},
      [](const EffectArguments& arguments) { return std::make_unique<RateLimit>(arguments); }};
  info.by_wheel = true;
  info.in_character = leaves_speed_free;
  return info;
}

}  // namespace wheelwright::effects

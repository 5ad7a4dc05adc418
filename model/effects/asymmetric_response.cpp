// asymmetric_response: speeding up and slowing down have different dynamics.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class AsymmetricResponse final : public EffectOf<AsymmetricResponse> {
 public:
  explicit AsymmetricResponse(const EffectArguments& arguments)
      : extra_lag_s_(arguments.parameters[0]),
        quick_lag_s_(arguments.parameters[1]),
        of_command_(arguments.variant == 0) {}

  void command(WheelPair& command_m_s, const Surroundings& around) override {
    if (of_command_) follow(command_m_s, around.period_s);
  }
  void wheel(WheelPair& speed_m_s, const Surroundings& around) override {
    if (!of_command_) follow(speed_m_s, around.period_s);
  }
  void reset() override { now_ = {}; }

 private:
  void follow(WheelPair& pair, double period_s) {
    follow(now_.left, pair.left, period_s);
    follow(now_.right, pair.right, period_s);
    pair = now_;
  }
  void follow(double& now, double wanted, double period_s) const {
    const bool slowing = std::abs(wanted) < std::abs(now) || wanted * now < 0.0;
    const bool slow = slowing == (extra_lag_s_ > 0.0);
    const double lag_s = quick_lag_s_ + (slow ? std::abs(extra_lag_s_) : 0.0);
    now += (wanted - now) * period_s / (period_s + lag_s);
  }

  double extra_lag_s_;
  double quick_lag_s_;
  bool of_command_;
  WheelPair now_;
};

}  // namespace

EffectInfo asymmetric_response() {
  return {"asymmetric_response",
          "speeding up and slowing down have different dynamics",
          "Drivers that coast instead of braking, PID loops that cannot brake: one of the two takes longer. "
          "'command': the drive itself, 'speed': the wheel behind it.",
          {{"command", EffectStage::command}, {"speed", EffectStage::wheel}},
          {{"extra_lag",
            "s",
            "time constant added when slowing down; negative: when speeding up",
            -0.6,
            0.6,
            {-0.2, -0.1, -0.05, -0.025, 0.025, 0.05, 0.1, 0.2},
            0.003},
           {"quick_lag",
            "s",
            "time constant of the quicker of the two, as far as the linear core does not hold it",
            0.0,
            0.6,
            {0.0},
            0.0,
            false}},
          {.variety = true},
          [](const EffectArguments& arguments) { return std::make_unique<AsymmetricResponse>(arguments); }};
}

}  // namespace wheelwright::effects

// asymmetric_response: speeding up and slowing down have different dynamics.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

// One of the two takes longer.
struct SlowOneWay {
  double extra_lag_s;
  double quick_lag_s;

  explicit SlowOneWay(std::span<const double> parameters)
      : extra_lag_s(parameters[0]), quick_lag_s(parameters[1]) {}

  double next(double now, double wanted, double period_s) const {
    const bool slowing = std::abs(wanted) < std::abs(now) || wanted * now < 0.0;
    const bool slow = slowing == (extra_lag_s > 0.0);
    const double lag_s = quick_lag_s + (slow ? std::abs(extra_lag_s) : 0.0);
    return now + (wanted - now) * period_s / (period_s + lag_s);
  }
};

// A motor whose current cannot turn round: where it would have to brake, it carries none, and the wheel rolls
// on. Only where much less is wanted does the drive's voltage turn round itself, and brakes after all.
struct Coasting {
  double rolling_time_s;
  double quick_lag_s;
  double brakes_below;

  explicit Coasting(std::span<const double> parameters)
      : rolling_time_s(parameters[0]), quick_lag_s(parameters[1]), brakes_below(parameters[2]) {}

  double next(double now, double wanted, double period_s) const {
    const double driven = now + (wanted - now) * period_s / (period_s + quick_lag_s);
    const double rolling = now * rolling_time_s / (rolling_time_s + period_s);
    const bool brakes = wanted * now < brakes_below * now * now;
    const bool rolls_on = !brakes && std::abs(driven) < std::abs(rolling);
    return rolls_on ? rolling : driven;
  }
};

template <typename Drive>
class Following final : public EffectOf<Following<Drive>> {
 public:
  explicit Following(const EffectArguments& arguments)
      : drive_(arguments.parameters), of_command_(arguments.variant % 2 == 0) {}

  void command(WheelPair& command_m_s, const StepContext& context) override {
    if (of_command_) follow(command_m_s, context.period_s);
  }
  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    if (!of_command_) follow(speed_m_s, context.period_s);
  }
  void reset() override { now_ = {}; }

 private:
  void follow(WheelPair& pair, double period_s) {
    now_.left = drive_.next(now_.left, pair.left, period_s);
    now_.right = drive_.next(now_.right, pair.right, period_s);
    pair = now_;
  }

  Drive drive_;
  bool of_command_;
  WheelPair now_;
};

constexpr std::size_t first_coasting = 2;

// What stops within a quarter of a second, no motor has let roll.
std::vector<ParameterInfo> coasting_parameters() {
  return {{"rolling_time", "s", "time constant of a wheel that rolls freely", 0.25, 6.0, {0.5, 1.5}, 0.0},
          {"quick_lag",
           "s",
           "time constant under power, as far as the linear part does not hold it",
           0.0,
           0.6,
           {0.0, 0.05},
           0.0,
           false},
          {"brakes_below",
           "1",
           "share of its speed below which what is wanted is reached by braking",
           0.0,
           0.95,
           {0.0, 0.45},
           0.0,
           false}};
}

// With one lag both ways, or a wheel that is always braked.
std::vector<double> same_both_ways(const EffectArguments& arguments) {
  std::vector<double> parameters(arguments.parameters.begin(), arguments.parameters.end());
  if (arguments.variant >= first_coasting) {
    parameters[2] = 1.0;
  } else {
    parameters[0] = 0.0;
  }
  return parameters;
}

}  // namespace

EffectInfo asymmetric_response() {
  EffectInfo info{
      "asymmetric_response",
      "speeding up and slowing down have different dynamics",
      "Drivers that coast instead of braking, PID loops that cannot brake: one of the two takes longer. "
      "'command': the drive itself, 'speed': the wheel behind it; '_coasting': slowing down, the wheel "
      "rolls freely until it is no faster than it should be.",
      {{"command", EffectStage::command},
       {"speed", EffectStage::wheel},
       {"command_coasting", EffectStage::command, coasting_parameters()},
       {"speed_coasting", EffectStage::wheel, coasting_parameters()}},
      {{"extra_lag",
        "s",
        "time constant added when slowing down; negative: when speeding up",
        -0.6,
        0.6,
        {-0.2, -0.1, -0.05, -0.025, 0.025, 0.05, 0.1, 0.2},
        0.003},
       {"quick_lag",
        "s",
        "time constant of the quicker of the two, as far as the linear part does not hold it",
        0.0,
        0.6,
        {0.0},
        0.0,
        false}},
      {.variety = true},
      [](const EffectArguments& arguments) -> std::unique_ptr<Effect> {
        if (arguments.variant >= first_coasting) return std::make_unique<Following<Coasting>>(arguments);
        return std::make_unique<Following<SlowOneWay>>(arguments);
      }};
  info.linear_part = same_both_ways;
  return info;
}

}  // namespace wheelwright::effects

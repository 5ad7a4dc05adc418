// asymmetric_response: speeding up and slowing down have different dynamics.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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
// on. Only where much less is wanted does the drive's voltage turn round itself, and brakes after all. Some
// drives wait for a wheel that turns the other way to slow down first.
struct Coasting {
  double rolling_time_s;
  double quick_lag_s;
  double brakes_below;
  double reverses_below_m_s;

  explicit Coasting(std::span<const double> parameters)
      : rolling_time_s(parameters[0]),
        quick_lag_s(parameters[1]),
        brakes_below(parameters[2]),
        reverses_below_m_s(parameters[3]) {}

  double next(double now, double wanted, double period_s) const {
    const double driven = now + (wanted - now) * period_s / (period_s + quick_lag_s);
    const double rolling = now * rolling_time_s / (rolling_time_s + period_s);
    const bool waits = wanted * now < 0.0 && std::abs(now) > reverses_below_m_s;
    const bool brakes = !waits && wanted * now < brakes_below * now * now;
    const bool rolls_on = !brakes && driven * now < rolling * now;
    return rolls_on ? rolling : driven;
  }
};

// The same, where the motor's lag is in the linear part and loads hold the wheel back. Of a motor with a lag
// of the first order, v' = (drive - load - v) / lag, the linear part gives y' = (drive - y) / lag; so the
// drive is y + lag y', and loads take T from the speed, with T' = (load - T) / lag. Without current the wheel
// obeys v' = -v / rolling_time - load / lag instead: what loads take is not given back.
class UnpoweredWheel {
 public:
  // The wheel's speed without what loads take in this period; `load_m_s` is what they took in the last one.
  double step(double linear_m_s, double load_m_s, std::span<const double> parameters, double period_s) {
    const double rolling_time_s = parameters[0];
    const double lag_s = parameters[1];
    const double brakes_below = parameters[2];
    const double reverses_below_m_s = parameters[3];
    const double share = -std::expm1(-period_s / lag_s);
    const double drive = linear_before_ + (linear_m_s - linear_before_) / share;
    const double kept_load = (1.0 - share) * load_m_s;
    const double load = load_before_ + (load_m_s - load_before_) / share;  // that the motor would settle at
    const double speed = now_ - load_m_s;
    const double driven = now_ + share * (drive - now_);
    const double rolling =
        speed * rolling_time_s / (rolling_time_s + period_s) + kept_load + (share - period_s / lag_s) * load;
    const double unbraked = driven * speed < rolling * speed ? rolling : driven;
    const double sign = std::copysign(1.0, speed);
    const double little_wanted_share = share_above_zero(sign * (brakes_below * speed - drive),
                                                        sign * (brakes_below * (driven - load_m_s) - drive));
    const double braked_share =
        sign * drive < 0.0
            ? little_wanted_share * share_below_zero(std::abs(speed) - reverses_below_m_s,
                                                     sign * (rolling - load_m_s) - reverses_below_m_s)
            : little_wanted_share;
    linear_before_ = linear_m_s;
    load_before_ = load_m_s;
    now_ = braked_share * driven + (1.0 - braked_share) * unbraked;
    return now_;
  }

 private:
  // Share of a period for which what goes from one value to another is above zero, if it began there.
  static double share_above_zero(double from, double to) {
    if (from <= 0.0) return 0.0;
    return to >= 0.0 ? 1.0 : from / (from - to);
  }

  // Share of a period for which what falls from one value to another is below zero.
  static double share_below_zero(double from, double to) {
    if (from <= 0.0) return 1.0;
    return to >= 0.0 ? 0.0 : to / (to - from);
  }

  double linear_before_ = 0.0;
  double load_before_ = 0.0;
  double now_ = 0.0;
};

class CoastingMotors final : public EffectOf<CoastingMotors> {
 public:
  explicit CoastingMotors(const EffectArguments& arguments) {
    std::ranges::copy(arguments.parameters, parameters_.begin());
  }
  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    speed_m_s = {left_.step(speed_m_s.left, context.load_m_s.left, parameters_, context.period_s),
                 right_.step(speed_m_s.right, context.load_m_s.right, parameters_, context.period_s)};
  }
  void reset() override { left_ = right_ = {}; }

 private:
  std::array<double, 4> parameters_{};
  UnpoweredWheel left_;
  UnpoweredWheel right_;
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
constexpr std::size_t motor_coasting = 4;

constexpr double at_any_speed_m_s = 3.0;

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
           false},
          {"reverses_below",
           "m/s",
           "speed of a wheel below which it is driven the other way; 3 m/s: at any speed",
           0.005,
           at_any_speed_m_s,
           {0.03, at_any_speed_m_s},
           0.0,
           false,
           at_any_speed_m_s}};
}

std::vector<ParameterInfo> motor_parameters() {
  std::vector<ParameterInfo> parameters = coasting_parameters();
  parameters[1] = {"lag", "s", "time constant under power", 0.005, 0.6, {0.04, 0.1}, 0.0, false};
  return parameters;
}

// With one lag both ways, or a wheel that is always braked.
std::vector<double> same_both_ways(const EffectArguments& arguments) {
  std::vector<double> parameters(arguments.parameters.begin(), arguments.parameters.end());
  if (arguments.variant >= first_coasting) {
    parameters[2] = 1.0;
    parameters[3] = at_any_speed_m_s;
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
      "rolls freely until it is no faster than it should be; 'motor_coasting': also "
      "where friction, a caster or a slope pushes the wheel.",
      {{"command", EffectStage::command},
       {"speed", EffectStage::wheel},
       {"command_coasting", EffectStage::command, coasting_parameters()},
       {"speed_coasting", EffectStage::wheel, coasting_parameters()},
       {"motor_coasting", EffectStage::wheel, motor_parameters(), true}},
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
        if (arguments.variant == motor_coasting) return std::make_unique<CoastingMotors>(arguments);
        if (arguments.variant >= first_coasting) return std::make_unique<Following<Coasting>>(arguments);
        return std::make_unique<Following<SlowOneWay>>(arguments);
      }};
  info.linear_part = same_both_ways;
  return info;
}

}  // namespace wheelwright::effects

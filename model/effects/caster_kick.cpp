// caster_kick: a short yaw disturbance after the direction of travel flips.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr double moving_m_s = 0.005;

// Variants, all of which come a second time at the wheels (model/at_the_wheels.hpp).
constexpr std::size_t swivel = 2;
constexpr std::size_t variants = 3;

class CasterKick final : public EffectOf<CasterKick> {
 public:
  explicit CasterKick(const EffectArguments& arguments)
      : angle_rad_(arguments.parameters[0]),
        distance_m_(arguments.parameters[1]),
        aside_(arguments.parameters[2]),
        alternates_(arguments.variant == 1) {}

  // The caster's swing grows by itself once begun and settles as it ends: a logistic curve of the distance
  // travelled since the flip. Who turns back half-way has that half of it to swing back.
  void body(Twist& twist, const Surroundings& around) override {
    const double v = twist.v_m_s;
    if (std::abs(v) > moving_m_s) {
      const double direction = std::copysign(1.0, v);
      if (direction_ != 0.0 && direction != direction_) {
        swung_ = std::clamp(1.0 - swung_, aside_, 1.0 - aside_);
        kick_rad_ = (alternates_ ? direction * angle_rad_ : angle_rad_) / (1.0 - aside_);
      }
      direction_ = direction;
    }
    const double ahead = (1.0 - swung_) * std::exp(-std::abs(v) * around.period_s / distance_m_);
    const double before = swung_;
    swung_ /= swung_ + ahead;
    twist.w_rad_s += kick_rad_ * (swung_ - before) / around.period_s;
  }
  void reset() override {
    direction_ = 0.0;
    kick_rad_ = 0.0;
    swung_ = 1.0;
  }

 private:
  double angle_rad_;
  double distance_m_;
  double aside_;
  bool alternates_;
  double direction_ = 0.0;  // of travel, once it has moved
  double kick_rad_ = 0.0;   // of the present swing
  double swung_ = 1.0;      // share of it
};

// A fork that is stiff in its pivot pushes for as long as it turns, at flips and in every turn. Its wheel is
// dragged after the pivot (a tractrix: the tangent of half the angle between the fork and where its pivot
// goes shrinks to 1/e within one trail), and what turns it against friction is a force on the robot's nose.
class StiffSwivel final : public EffectOf<StiffSwivel> {
 public:
  explicit StiffSwivel(const EffectArguments& arguments)
      : push_m_s_(arguments.parameters[0]),
        trail_m_(arguments.parameters[1]),
        ahead_m_(arguments.parameters[2]) {}

  void body(Twist& twist, const Surroundings& around) override {
    const double turned_rad = dragged_rad(twist, around.period_s);
    const double middle_rad = fork_rad_ + 0.5 * turned_rad;
    fork_rad_ += turned_rad - twist.w_rad_s * around.period_s;
    const double swivel_rad_s = turned_rad / around.period_s - twist.w_rad_s;
    const double push_m_s = push_m_s_ * std::tanh(swivel_rad_s / sliding_rad_s);
    // Wheels that give way by that much to a force along the robot turn it by this much for one across.
    const double arm_1_m = 4.0 * ahead_m_ / (around.wheel_base_m * around.wheel_base_m);
    twist.v_m_s += push_m_s * std::sin(middle_rad);
    twist.w_rad_s -= push_m_s * std::cos(middle_rad) * arm_1_m;
  }
  void reset() override { fork_rad_ = 0.0; }

 private:
  static constexpr double sliding_rad_s = 0.7;  // where friction of the pivot has its full size

  // Seen from the floor, in the middle of the period's turn.
  double dragged_rad(const Twist& twist, double period_s) const {
    const double sideways_m_s = twist.w_rad_s * ahead_m_;
    const double heading_rad = std::atan2(sideways_m_s, twist.v_m_s);
    const double off_rad =
        std::remainder(fork_rad_ - 0.5 * twist.w_rad_s * period_s - heading_rad, 2.0 * std::numbers::pi);
    const double shrunk = std::exp(-std::hypot(twist.v_m_s, sideways_m_s) * period_s / trail_m_);
    return 2.0 * std::atan(std::tan(0.5 * off_rad) * shrunk) - off_rad;
  }

  double push_m_s_;
  double trail_m_;
  double ahead_m_;
  double fork_rad_ = 0.0;  // from behind the pivot, seen from the robot
};

std::vector<ParameterInfo> swivel_parameters() {
  return {{"push",
           "m/s",
           "speed that the fork's friction takes when it points backward",
           0.0,
           0.3,
           {0.003, 0.015},
           0.0003},
          {"trail", "m", "of the fork: its wheel behind its pivot", 0.003, 0.2, {0.015, 0.04}, 0.0, false},
          {"arm",
           "m",
           "from the axle to the fork's pivot; behind the axle is hardly another",
           0.0,
           0.5,
           {0.1},
           0.0,
           false}};
}

// What turns the robot by as much as that is no caster's swing.
bool only_kicks(const EffectArguments& caster, double) {
  constexpr double largest_kick_rad = 0.5;
  return caster.variant % variants == swivel || std::abs(caster.parameters[0]) < largest_kick_rad;
}

}  // namespace

EffectInfo caster_kick() {
  EffectInfo info{
      "caster_kick",
      "a short yaw disturbance after the direction of travel flips",
      "A caster swings round and pushes the robot aside while it does. 'same': to the same side at every "
      "flip, 'alternating': to one side when it begins to go forward, to the other when backward; 'swivel': "
      "by the friction of its pivot, in turns as well.",
      {{"same", EffectStage::body},
       {"alternating", EffectStage::body},
       {"swivel", EffectStage::body, swivel_parameters()}},
      {{"angle", "rad", "turn that one kick makes in all", -1.0, 1.0, {-0.05, -0.02, 0.02, 0.05}, 0.002},
       {"distance",
        "m",
        "of travel in which the swing grows or settles to 1/e",
        0.003,
        0.5,
        {0.015, 0.05},
        0.0,
        false},
       {"aside",
        "1",
        "share of its swing at which the caster stands at the flip: little, and the kick comes late",
        0.001,
        0.5,
        {0.01, 0.3},
        0.0,
        false}},
      {.reference = true, .reversal = true},
      [](const EffectArguments& arguments) -> std::unique_ptr<Effect> {
        if (arguments.variant == swivel) return std::make_unique<StiffSwivel>(arguments);
        return std::make_unique<CasterKick>(arguments);
      },
      true};
  info.in_character = only_kicks;
  return info;
}

}  // namespace wheelwright::effects

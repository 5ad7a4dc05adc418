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

// Each tyre pushes the robot as hard as it takes to stay with its wheel, up to its grip. A push at one side
// is felt at the other: with forces f per mass of the robot, and with `turning`, which is mass * (wheel base
// / 2)^2 / inertia, the floor under the left wheel goes by with an acceleration of
//
//   (1 + turning) f_left + (1 - turning) f_right
//
// and likewise on the right. Both at their grip in one direction speed the robot up by 1 / slip.
class TiedTyres final : public EffectOf<TiedTyres> {
 public:
  explicit TiedTyres(const EffectArguments& arguments)
      : most_m_s2_(0.5 / std::max(arguments.parameters[0], stiffest)),
        own_(1.0 + arguments.parameters[1]),
        across_(1.0 - arguments.parameters[1]) {}

  void floor(WheelPair& speed_m_s, const StepContext& context) override {
    const WheelPair wanted_m_s2{(speed_m_s.left - floor_m_s_.left) / context.period_s,
                                (speed_m_s.right - floor_m_s_.right) / context.period_s};
    const WheelPair push_m_s2 = pushes(wanted_m_s2);
    floor_m_s_.left += (own_ * push_m_s2.left + across_ * push_m_s2.right) * context.period_s;
    floor_m_s_.right += (own_ * push_m_s2.right + across_ * push_m_s2.left) * context.period_s;
    speed_m_s = floor_m_s_;
  }
  void reset() override { floor_m_s_ = {}; }

 private:
  static constexpr double stiffest = 1e-3;  // s^2/m: as good as no slip

  WheelPair pushes(const WheelPair& wanted_m_s2) const {
    const double scale = 1.0 / (own_ * own_ - across_ * across_);
    WheelPair push{scale * (own_ * wanted_m_s2.left - across_ * wanted_m_s2.right),
                   scale * (own_ * wanted_m_s2.right - across_ * wanted_m_s2.left)};
    if (std::abs(push.left) > std::abs(push.right)) {
      hold_to_grip(push.left, push.right, wanted_m_s2.right);
    } else {
      hold_to_grip(push.right, push.left, wanted_m_s2.left);
    }
    return push;
  }
  // Where the tyre that would have to push the harder slides, the other does on its side what is left to do.
  void hold_to_grip(double& harder, double& other, double wanted_of_other) const {
    if (std::abs(harder) <= most_m_s2_) return;
    harder = std::copysign(most_m_s2_, harder);
    other = std::clamp((wanted_of_other - across_ * harder) / own_, -most_m_s2_, most_m_s2_);
  }

  double most_m_s2_;  // of one tyre's force, per mass of the robot
  double own_;        // acceleration of a side by its own tyre's push ...
  double across_;     // ... and by the other one's
  WheelPair floor_m_s_;
};

constexpr std::size_t tied = 3;

std::vector<ParameterInfo> tied_parameters() {
  return {{"slip",
           "s^2/m",
           "1 / acceleration at which both tyres slide",
           0.0,
           3.0,
           {0.3, 0.5, 0.8, 1.2, 1.8},
           0.003},
          {"turning",
           "1",
           "how much more easily the robot is turned than driven: mass * (wheel base / 2)^2 / inertia",
           0.2,
           5.0,
           {0.7, 1.4},
           0.0,
           false}};
}

}  // namespace

EffectInfo acceleration_slip() {
  return {
      "acceleration_slip",
      "distance is lost when speeding up or slowing down hard",
      "The tyre slips in proportion to what acceleration asks of it beyond its grip. Encoders count what "
      "the floor does not give. 'relative': a share of the speed; 'absolute': the same at any speed "
      "(unit: share of 0.2 m/s); 'sliding': beyond its grip it slides, and the robot speeds up and slows "
      "down by no more than 1 / slip until it has caught up; 'tied': likewise, with the mass of the robot "
      "between the two, so that it turns aside where one tyre slides.",
      {{"relative", EffectStage::floor},
       {"absolute", EffectStage::floor},
       {"sliding", EffectStage::floor},
       {"tied", EffectStage::floor, tied_parameters()}},
      {{"slip",
        "s^2/m",
        "share of the speed lost per m/s^2 beyond the grip",
        0.0,
        3.0,
        {0.03, 0.08, 0.2, 0.5, 1.0, 1.6},
        0.003},
       {"grip", "m/s^2", "acceleration without slip", 0.0, 5.0, {0.0, 0.3, 0.7}, 0.0, false}},
      {.reference = true},
      [](const EffectArguments& arguments) -> std::unique_ptr<Effect> {
        if (arguments.variant == tied) return std::make_unique<TiedTyres>(arguments);
        return std::make_unique<AccelerationSlip>(arguments);
      }};
}

}  // namespace wheelwright::effects

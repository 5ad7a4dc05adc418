// turn_scrub: turn rate is lost as turning gets harder (nonlinear in turn rate).
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"
#include "model/effects/odd_bend.hpp"

namespace wheelwright::effects {
namespace {

// Variants, which come a second time at the wheels (model/effects/library/wheel_load_variants.hpp).
constexpr std::size_t drag = 1;
constexpr std::size_t creep = 2;

// A part that grows with the turn rate is taken from it: size (1 - loss size - square size^2), up to where it
// would fall again; or a drag that grows with it shares the turn with the wheels: size / (1 + loss size +
// square size^2). Dry tyres take their part of any turn rate.
class TurnScrub final : public EffectOf<TurnScrub> {
 public:
  explicit TurnScrub(const EffectArguments& arguments)
      : loss_(arguments.parameters[0]),
        square_(arguments.parameters[1]),
        bend_(loss_, square_, min_top_rad_s),
        dry_rad_s_(arguments.parameters[2]),
        drags_(arguments.variant == drag) {}

  void body(Twist& twist, const StepContext&) override {
    const double bent = drags_ ? dragged(twist.w_rad_s) : bend_(twist.w_rad_s);
    twist.w_rad_s = std::copysign(std::max(0.0, std::abs(bent) - dry_rad_s_), bent);
  }

 private:
  double dragged(double rate) const {
    const double size = std::abs(rate);
    return rate / std::max(min_drag, 1.0 + size * (loss_ + square_ * size));
  }

  static constexpr double min_top_rad_s = 0.5;
  static constexpr double min_drag = 0.5;

  double loss_;
  double square_;
  OddBend bend_;
  double dry_rad_s_;
  bool drags_;
};

// Dry tyres creep before they slide, and take their whole part of a turn rate only from some rate on: u =
// dry tanh(w / sliding), of the rate w that is left. Of the rate w(0) = w + u without it, u =
// dry tanh(w(0) / (sliding + dry)) has the same slope at 0, and the same limit. Wheels give way to it with a
// lag of the first order.
class CreepingTyres final : public EffectOf<CreepingTyres> {
 public:
  explicit CreepingTyres(const EffectArguments& arguments)
      : dry_rad_s_(arguments.parameters[0]),
        sliding_rad_s_(arguments.parameters[1]),
        lag_s_(arguments.parameters[2]) {}

  void body(Twist& twist, const StepContext& context) override {
    const double share = context.period_s / (context.period_s + lag_s_);
    const double kept = (1.0 - share) * taken_rad_s_;
    const double whole = share * dry_rad_s_;
    taken_rad_s_ = kept + whole * std::tanh((twist.w_rad_s - kept) / (sliding_rad_s_ + whole));
    twist.w_rad_s -= taken_rad_s_;
  }
  void reset() override { taken_rad_s_ = 0.0; }

 private:
  double dry_rad_s_;
  double sliding_rad_s_;
  double lag_s_;
  double taken_rad_s_ = 0.0;
};

std::vector<ParameterInfo> creep_parameters() {
  return {
      {"dry", "rad/s", "lost where the tyres slide", 0.0, 0.5, {0.03}, 0.01},
      {"sliding", "rad/s", "turn rate at which the tyres nearly slide", 0.003, 1.0, {0.03, 0.2}, 0.0, false},
      {"lag", "s", "with which the wheels give way to it", 0.0, 0.3, {0.03}, 0.0, false}};
}

}  // namespace

EffectInfo turn_scrub() {
  return {"turn_scrub",
          "turn rate is lost as turning gets harder (nonlinear in turn rate)",
          "The tyres' contact patches are dragged sideways: dry ones take a part of any turn rate, others "
          "take the more the faster the robot turns; '' takes a part away, 'drag' works against the wheels; "
          "'creep': dry tyres that give way before they slide.",
          {{"", EffectStage::body},
           {"drag", EffectStage::body},
           {"creep", EffectStage::body, creep_parameters()}},
          {{"loss", "s/rad", "share of the turn rate lost per rad/s", 0.0, 2.0, {0.05}, 0.005},
           {"square",
            "s^2/rad^2",
            "further share that grows with the square of the turn rate",
            -1.0,
            2.0,
            {0.05},
            0.005},
           {"dry", "rad/s", "lost at any turn rate", 0.0, 0.5, {0.03}, 0.01}},
          {.reference = true, .or_gyro = true, .heading = true, .turning = true, .variety = true},
          [](const EffectArguments& arguments) -> std::unique_ptr<Effect> {
            if (arguments.variant == creep) return std::make_unique<CreepingTyres>(arguments);
            return std::make_unique<TurnScrub>(arguments);
          },
          true};
}

}  // namespace wheelwright::effects

// turn_scrub: turn rate is lost as turning gets harder (nonlinear in turn rate).
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class TurnScrub final : public EffectOf<TurnScrub> {
 public:
  explicit TurnScrub(const EffectArguments& arguments)
      : loss_(arguments.parameters[0]), linear_(arguments.variant == 1) {}

  // Where the loss would turn the robot more slowly for more, its rate stays.
  void body(Twist& twist, const Surroundings&) override {
    double size = std::abs(twist.w_rad_s);
    if (loss_ > 0.0) size = std::min(size, linear_ ? 0.5 / loss_ : 1.0 / std::sqrt(3.0 * loss_));
    const double lost = linear_ ? loss_ * size : loss_ * size * size;
    twist.w_rad_s = std::copysign(size * (1.0 - lost), twist.w_rad_s);
  }

 private:
  double loss_;
  bool linear_;
};

}  // namespace

EffectInfo turn_scrub() {
  return {"turn_scrub",
          "turn rate is lost as turning gets harder (nonlinear in turn rate)",
          "The tyres' contact patches are dragged sideways, the more the faster the robot turns. 'square': "
          "the loss "
          "grows with the square of the turn rate, 'linear': with its size.",
          {{"square", EffectStage::body}, {"linear", EffectStage::body}},
          {{"loss",
            "s^n/rad^n",
            "share of the turn rate lost at 1 rad/s",
            -0.3,
            1.5,
            {0.01, 0.03, 0.06, 0.12, 0.25},
            0.002}},
          {.reference = true, .heading = true, .turning = true},
          [](const EffectArguments& arguments) { return std::make_unique<TurnScrub>(arguments); },
          true};
}

}  // namespace wheelwright::effects

// turn_scrub: turn rate is lost as turning gets harder (nonlinear in turn rate).
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"
#include "model/effects/odd_bend.hpp"

namespace wheelwright::effects {
namespace {

// size (1 - loss size - square size^2), up to where it would fall again, and less what dry tyres take of any
// turn rate.
class TurnScrub final : public EffectOf<TurnScrub> {
 public:
  explicit TurnScrub(const EffectArguments& arguments)
      : bend_(arguments.parameters[0], arguments.parameters[1], least_top_rad_s),
        dry_rad_s_(arguments.parameters[2]) {}

  void body(Twist& twist, const Surroundings&) override {
    const double bent = bend_(twist.w_rad_s);
    twist.w_rad_s = std::copysign(std::max(0.0, std::abs(bent) - dry_rad_s_), bent);
  }

 private:
  static constexpr double least_top_rad_s = 0.5;

  OddBend bend_;
  double dry_rad_s_;
};

}  // namespace

EffectInfo turn_scrub() {
  return {"turn_scrub",
          "turn rate is lost as turning gets harder (nonlinear in turn rate)",
          "The tyres' contact patches are dragged sideways: dry ones take a part of any turn rate, others "
          "take the more the faster the robot turns.",
          {{"", EffectStage::body}},
          {{"loss", "s/rad", "share of the turn rate lost per rad/s", 0.0, 2.0, {0.05}, 0.005},
           {"square",
            "s^2/rad^2",
            "further share that grows with the square of the turn rate",
            -1.0,
            2.0,
            {0.05},
            0.005},
           {"dry", "rad/s", "lost at any turn rate", 0.0, 0.5, {0.03}, 0.01}},
          {.reference = true, .heading = true, .turning = true, .variety = true},
          [](const EffectArguments& arguments) { return std::make_unique<TurnScrub>(arguments); },
          true};
}

}  // namespace wheelwright::effects

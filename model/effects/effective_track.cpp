// effective_track: the distance between wheels that turning shows is not the given one.
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class EffectiveTrack final : public EffectOf<EffectiveTrack> {
 public:
  explicit EffectiveTrack(const EffectArguments& arguments) : excess_m_(arguments.parameters[0]) {}

  void body(Twist& twist, const StepContext& context) override {
    twist.w_rad_s *= context.wheel_base_m / (context.wheel_base_m + excess_m_);
  }

 private:
  double excess_m_;
};

}  // namespace

EffectInfo effective_track() {
  return {"effective_track",
          "the distance between wheels that turning shows is not the given one",
          "Wide or soft tyres touch the floor elsewhere than in the middle. The same ratio at every turn "
          "rate, which "
          "distinguishes it from scrub. Without counts, places that are out of scale look the same.",
          {{"", EffectStage::body}},
          {{"excess",
            "m",
            "effective minus given wheel base",
            -0.08,
            0.3,
            {-0.02, -0.01, -0.004, 0.004, 0.01, 0.02, 0.04},
            0.0006}},
          {.reference = true, .heading = true, .turning = true},
          [](const EffectArguments& arguments) { return std::make_unique<EffectiveTrack>(arguments); }};
}

}  // namespace wheelwright::effects

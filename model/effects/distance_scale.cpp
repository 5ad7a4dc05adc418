// distance_scale: both wheels roll more or less than counted.
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class DistanceScale final : public EffectOf<DistanceScale> {
 public:
  explicit DistanceScale(const EffectArguments& arguments) : change_(arguments.parameters[0]) {}

  void floor(WheelPair& speed_m_s, const StepContext&) override {
    both(speed_m_s, [this](double speed) { return speed * (1.0 + change_); });
  }
  WheelPair rolling() const override { return {1.0 + change_, 1.0 + change_}; }

 private:
  double change_;
};

}  // namespace

EffectInfo distance_scale() {
  return {"distance_scale",
          "both wheels roll more or less than counted",
          "Metres per tick are not what the log says: tyre wear, load, carpet. Takes counts and an outside "
          "distance.",
          {{"", EffectStage::floor}},
          {{"change",
            "1",
            "relative change of metres per tick",
            -0.5,
            0.5,
            {-0.05, -0.02, -0.01, 0.01, 0.02, 0.05},
            0.0008}},
          {.reference = true, .place = true, .encoders = true},
          [](const EffectArguments& arguments) { return std::make_unique<DistanceScale>(arguments); }};
}

}  // namespace wheelwright::effects

// distance_scale: both wheels roll more or less than counted.
#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class DistanceScale final : public EffectOf<DistanceScale> {
 public:
  explicit DistanceScale(const EffectArguments& arguments)
      : change_(arguments.parameters[0]), turns_as_counted_(arguments.variant == 1) {}

  void floor(WheelPair& speed_m_s, const StepContext&) override {
    if (turns_as_counted_) {
      const double more = change_ * 0.5 * (speed_m_s.left + speed_m_s.right);
      both(speed_m_s, [more](double speed) { return speed + more; });
    } else {
      both(speed_m_s, [this](double speed) { return speed * (1.0 + change_); });
    }
  }
  WheelPair rolling() const override {
    if (turns_as_counted_) return {1.0, 1.0};
    return {1.0 + change_, 1.0 + change_};
  }

 private:
  double change_;
  bool turns_as_counted_;
};

}  // namespace

EffectInfo distance_scale() {
  return {"distance_scale",
          "both wheels roll more or less than counted, or the reference is out of scale",
          "Metres per tick are not what the log says: tyre wear, load, carpet. Takes counts and an outside "
          "distance. 'turns_as_counted': the given wheel base is wrong by the same share, as after a "
          "calibration of metres per tick by turning on it.",
          {{"", EffectStage::floor}, {"turns_as_counted", EffectStage::floor}},
          {{"change",
            "1",
            "relative change of metres per tick",
            -0.5,
            0.5,
            {-0.05, -0.02, -0.01, 0.01, 0.02, 0.05},
            0.0008}},
          {.reference = true, .place = true, .encoders = true, .scale = true},
          [](const EffectArguments& arguments) { return std::make_unique<DistanceScale>(arguments); }};
}

}  // namespace wheelwright::effects

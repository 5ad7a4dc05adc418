// surface_patch: motion differs inside a region of the floor.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class SurfacePatch final : public EffectOf<SurfacePatch> {
 public:
  explicit SurfacePatch(const EffectArguments& arguments)
      : change_(arguments.parameters[0]),
        x_m_(arguments.parameters[1]),
        y_m_(arguments.parameters[2]),
        half_length_m_(0.5 * arguments.parameters[3]),
        half_width_m_(0.5 * arguments.parameters[4]),
        cosine_(std::cos(arguments.parameters[5])),
        sine_(std::sin(arguments.parameters[5])),
        seen_by_encoder_(arguments.variant == 1) {}

  void wheel(WheelPair& speed_m_s, const Surroundings& around) override {
    if (!seen_by_encoder_) return;
    const double gain = gain_at(around.pose);
    both(speed_m_s, [gain](double speed) { return gain * speed; });
  }
  void body(Twist& twist, const Surroundings& around) override {
    if (seen_by_encoder_) return;
    const double gain = gain_at(around.pose);
    twist.v_m_s *= gain;
    twist.w_rad_s *= gain;
  }

 private:
  static constexpr double edge_m = 0.02;  // the robot does not change floors within one millimetre

  static double share_inside(double inside_m) {
    return std::fmin(1.0, std::fmax(0.0, 0.5 + inside_m / edge_m));
  }
  double gain_at(const Pose& pose) const {
    const double dx = pose.x_m - x_m_;
    const double dy = pose.y_m - y_m_;
    return 1.0 + change_ * share_inside(half_length_m_ - std::abs(cosine_ * dx + sine_ * dy)) *
                     share_inside(half_width_m_ - std::abs(cosine_ * dy - sine_ * dx));
  }

  double change_;
  double x_m_;
  double y_m_;
  double half_length_m_;
  double half_width_m_;
  double cosine_;
  double sine_;
  bool seen_by_encoder_;
};

}  // namespace

EffectInfo surface_patch() {
  return {"surface_patch",
          "motion differs inside a region of the floor",
          "A rug, a wet or worn place. Come back to it: time and battery have changed, the place has not. "
          "'floor': the "
          "wheels slip there, 'wheel': they turn more slowly and the encoders see it.",
          {{"floor", EffectStage::body}, {"wheel", EffectStage::wheel}},
          {{"change", "1", "relative change of motion inside", -0.9, 0.9, {-0.1}, 0.01},
           {"x", "m", "middle of the region, in the frame of the reference", -100.0, 100.0, {}, 0.0, false},
           {"y", "m", "middle of the region", -100.0, 100.0, {}, 0.0, false},
           {"length", "m", "of the region, a rectangle", 0.1, 40.0, {0.5, 1.0}, 0.0, false},
           {"width", "m", "of the region", 0.1, 40.0, {0.5, 1.0}, 0.0, false},
           {"heading", "rad", "of its length", -1.6, 1.6, {0.1}, 0.0, false}},
          {.reference = true, .place = true},
          [](const EffectArguments& arguments) { return std::make_unique<SurfacePatch>(arguments); }};
}

}  // namespace wheelwright::effects

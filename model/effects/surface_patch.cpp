// surface_patch: motion differs inside a region of the floor.
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class SurfacePatch final : public EffectOf<SurfacePatch> {
 public:
  static constexpr bool loads_motors = true;

  explicit SurfacePatch(const EffectArguments& arguments)
      : change_(arguments.parameters[0]),
        x_m_(arguments.parameters[1]),
        y_m_(arguments.parameters[2]),
        half_length_m_(0.5 * arguments.parameters[3]),
        half_width_m_(0.5 * arguments.parameters[4]),
        cosine_(std::cos(arguments.parameters[5])),
        sine_(std::sin(arguments.parameters[5])),
        seen_by_encoder_(arguments.variant % 2 == 1),
        under_each_(arguments.variant / 2 % 2 == 1),
        round_(arguments.variant >= 4),
        lag_s_(seen_by_encoder_ ? arguments.parameters[6] : 0.0) {}

  void wheel(WheelPair& speed_m_s, const StepContext& context) override {
    if (seen_by_encoder_) slow_down(speed_m_s, context);
  }
  void floor(WheelPair& speed_m_s, const StepContext& context) override {
    if (!seen_by_encoder_) slow_down(speed_m_s, context);
  }
  void reset() override { began_ = false; }

 private:
  static constexpr double edge_m = 0.02;  // the robot does not change floors within one millimetre

  static double share_inside(double inside_m) {
    return std::fmin(1.0, std::fmax(0.0, 0.5 + inside_m / edge_m));
  }
  // The region takes effect where the robot's middle is, or under each wheel by itself.
  void slow_down(WheelPair& speed_m_s, const StepContext& context) {
    const double half = under_each_ ? 0.5 * context.wheel_base_m : 0.0;
    const double aside_x = -half * std::sin(context.pose.theta_rad);
    const double aside_y = half * std::cos(context.pose.theta_rad);
    const WheelPair there{gain_at(context.pose.x_m + aside_x, context.pose.y_m + aside_y),
                          gain_at(context.pose.x_m - aside_x, context.pose.y_m - aside_y)};
    const double fresh = began_ && lag_s_ > 0.0 ? -std::expm1(-context.period_s / lag_s_) : 1.0;
    gain_.left += fresh * (there.left - gain_.left);
    gain_.right += fresh * (there.right - gain_.right);
    began_ = true;
    speed_m_s.left *= gain_.left;
    speed_m_s.right *= gain_.right;
  }
  double gain_at(double at_x_m, double at_y_m) const {
    const double dx = at_x_m - x_m_;
    const double dy = at_y_m - y_m_;
    const double along_m = cosine_ * dx + sine_ * dy;
    const double across_m = cosine_ * dy - sine_ * dx;
    if (round_) return 1.0 + change_ * share_inside(inside_ellipse_m(along_m, across_m));
    return 1.0 + change_ * share_inside(half_length_m_ - std::abs(along_m)) *
                     share_inside(half_width_m_ - std::abs(across_m));
  }
  // How far the edge is, to first order; infinitely far in the middle.
  double inside_ellipse_m(double along_m, double across_m) const {
    const double along = along_m / half_length_m_;
    const double across = across_m / half_width_m_;
    const double slope_1_m = 2.0 * std::hypot(along / half_length_m_, across / half_width_m_);
    return (1.0 - along * along - across * across) / slope_1_m;
  }

  double change_;
  double x_m_;
  double y_m_;
  double half_length_m_;
  double half_width_m_;
  double cosine_;
  double sine_;
  bool seen_by_encoder_;
  bool under_each_;
  bool round_;
  double lag_s_;
  bool began_ = false;
  WheelPair gain_;
};

std::vector<ParameterInfo> region() {
  return {{"change", "1", "relative change of motion inside", -0.9, 0.9, {-0.1}, 0.01},
          {"x", "m", "middle of the region, in the frame of the reference", -100.0, 100.0, {}, 0.0, false},
          {"y", "m", "middle of the region", -100.0, 100.0, {}, 0.0, false},
          {"length", "m", "of the region, a rectangle or an ellipse", 0.1, 40.0, {0.5, 1.0}, 0.0, false},
          {"width", "m", "of the region", 0.1, 40.0, {0.5, 1.0}, 0.0, false},
          {"heading", "rad", "of its length", -1.6, 1.6, {0.1}, 0.0, false}};
}

// Wheels that turn need a while to slow down and to speed up again.
std::vector<ParameterInfo> region_for_motors() {
  std::vector<ParameterInfo> parameters = region();
  parameters.push_back(
      {"lag", "s", "time constant in which the wheels take on the change", 0.0, 1.0, {0.1}, 0.0, false});
  return parameters;
}

}  // namespace

EffectInfo surface_patch() {
  EffectInfo info{
      "surface_patch",
      "motion differs inside a region of the floor",
      "A rug, a wet or worn place. Come back to it: time and battery have changed, the place has not. "
      "'floor': the wheels slip there, 'wheel': they turn more slowly and the encoders see it, "
      "after a lag; '_each': under each wheel by itself, so that the robot turns at the edge; '_round': an "
      "ellipse.",
      {{"floor", EffectStage::floor},
       {"wheel", EffectStage::wheel, region_for_motors()},
       {"floor_each", EffectStage::floor},
       {"wheel_each", EffectStage::wheel, region_for_motors()},
       {"floor_round", EffectStage::floor},
       {"wheel_round", EffectStage::wheel, region_for_motors()},
       {"floor_each_round", EffectStage::floor},
       {"wheel_each_round", EffectStage::wheel, region_for_motors()}},
      region(),
      {.reference = true, .place = true},
      [](const EffectArguments& arguments) { return std::make_unique<SurfacePatch>(arguments); }};
  info.by_pose = true;
  return info;
}

}  // namespace wheelwright::effects

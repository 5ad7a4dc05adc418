// gain_curve: gain bends with command size.
#include <algorithm>
#include <cmath>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

class GainCurve final : public EffectOf<GainCurve> {
 public:
  explicit GainCurve(const EffectArguments& arguments)
      : curvature_(arguments.parameters[0]),
        cubic_(arguments.variant == 1 || arguments.variant == 3),
        of_command_(arguments.variant < 2) {}

  void command(WheelPair& command_m_s, const Surroundings&) override {
    if (of_command_) bend(command_m_s);
  }
  void wheel(WheelPair& speed_m_s, const Surroundings&) override {
    if (!of_command_) bend(speed_m_s);
  }

 private:
  static constexpr double usual_command_m_s = 0.3;  // gives both variants the same unit

  void bend(WheelPair& pair) const {
    both(pair, [this](double u) { return cubic_ ? cubic(u) : quadratic(u); });
  }

  // Where the parabola would fall again, the speed stays.
  double quadratic(double u) const {
    const double size = curvature_ > 0.0 ? std::min(std::abs(u), 0.5 / curvature_) : std::abs(u);
    return std::copysign(size * (1.0 - curvature_ * size), u);
  }
  double cubic(double u) const {
    const double c = curvature_ / usual_command_m_s;
    const double size = c > 0.0 ? std::min(std::abs(u), 1.0 / std::sqrt(3.0 * c)) : std::abs(u);
    return std::copysign(size * (1.0 - c * size * size), u);
  }

  double curvature_;
  bool cubic_;
  bool of_command_;
};

}  // namespace

EffectInfo gain_curve() {
  return {"gain_curve",
          "gain bends with command size",
          "Motor drivers and firmware tables that give less (or more) for large commands in proportion. "
          "'quadratic': "
          "the gain falls by curvature times |command|; 'cubic': with its square, as much at 0.3 m/s; "
          "'speed' and "
          "'speed_cubic': the same of the wheel's speed, behind its lag.",
          {{"quadratic", EffectStage::command},
           {"cubic", EffectStage::command},
           {"speed", EffectStage::wheel},
           {"speed_cubic", EffectStage::wheel}},
          {{"curvature",
            "s/m",
            "relative loss of gain per m/s of command",
            -3.0,
            3.0,
            {-1.0, -0.3, -0.1, 0.1, 0.3, 1.0},
            0.02}},
          {.variety = true},
          [](const EffectArguments& arguments) { return std::make_unique<GainCurve>(arguments); }};
}

}  // namespace wheelwright::effects

// gain_curve: gain bends with command size.
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

// size (1 - curvature size - cubic size^2), up to where it would fall again.
class GainCurve final : public EffectOf<GainCurve> {
 public:
  explicit GainCurve(const EffectArguments& arguments)
      : curvature_(arguments.parameters[0]),
        cubic_(arguments.parameters[1] / usual_command_m_s),
        of_command_(arguments.variant == 0) {
    const double discriminant = curvature_ * curvature_ + 3.0 * cubic_;
    if (discriminant < 0.0) return;
    const double per_m_s = curvature_ + std::sqrt(discriminant);
    if (per_m_s > 0.0) top_m_s_ = 1.0 / per_m_s;
  }

  void command(WheelPair& command_m_s, const Surroundings&) override {
    if (of_command_) bend(command_m_s);
  }
  void wheel(WheelPair& speed_m_s, const Surroundings&) override {
    if (!of_command_) bend(speed_m_s);
  }

 private:
  static constexpr double usual_command_m_s = 0.3;  // gives both parameters the same unit

  void bend(WheelPair& pair) const {
    both(pair, [this](double u) {
      const double size = std::min(std::abs(u), top_m_s_);
      return std::copysign(size * (1.0 - size * (curvature_ + cubic_ * size)), u);
    });
  }

  double curvature_;
  double cubic_;
  bool of_command_;
  double top_m_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace

EffectInfo gain_curve() {
  return {"gain_curve",
          "gain bends with command size",
          "Motor drivers and firmware tables that give less (or more) for large commands in proportion. "
          "'command': of what the motor is told, 'speed': of what the wheel does, behind its lag.",
          {{"command", EffectStage::command}, {"speed", EffectStage::wheel}},
          {{"curvature", "s/m", "relative loss of gain per m/s of command", -3.0, 3.0, {0.1}},
           {"cubic",
            "s/m",
            "further loss that grows with the square of the command, by as much at 0.3 m/s",
            -3.0,
            3.0,
            {0.1}}},
          {.variety = true},
          [](const EffectArguments& arguments) { return std::make_unique<GainCurve>(arguments); }};
}

}  // namespace wheelwright::effects

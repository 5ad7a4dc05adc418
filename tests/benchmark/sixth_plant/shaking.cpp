#include "tests/benchmark/sixth_plant/shaking.hpp"

#include <cmath>

#include "tests/benchmark/sixth_plant/dice.hpp"

namespace plants::sixth {

Shaking::Shaking(const Robot& robot, const Random& random)
    : spec_(robot.noise),
      yield_n_s_m_(robot.yield_n_s_m()),
      motor_n_s_m_(robot.motor_n_s_m),
      random_(random) {
  for (const std::size_t side : {left_side, right_side}) {
    fast_m_s_[side] = spec_.fast_m_s.sigma * bell(random_);
    slow_m_s_[side] = spec_.slow_m_s.sigma * bell(random_);
  }
  turn_rad_s_ = spec_.turn_rad_s.sigma * bell(random_);
  forward_m_s_ = spec_.forward_m_s.sigma * bell(random_);
}

void Shaking::forget_and_draw(double& value, const NoiseSpec& spec) {
  constexpr double held_s = 0.001;
  value +=
      -value * held_s / spec.memory_s + spec.sigma * std::sqrt(2 * held_s / spec.memory_s) * bell(random_);
}

void Shaking::step() {
  for (const std::size_t side : {left_side, right_side}) {
    forget_and_draw(fast_m_s_[side], spec_.fast_m_s);
    forget_and_draw(slow_m_s_[side], spec_.slow_m_s);
    voltage_m_s_[side] = spec_.loop_m_s * bell(random_);
  }
  forget_and_draw(turn_rad_s_, spec_.turn_rad_s);
  forget_and_draw(forward_m_s_, spec_.forward_m_s);
}

double Shaking::load_n(std::size_t side) const {
  return yield_n_s_m_ * (fast_m_s_[side] * 2 + slow_m_s_[side]);
}

double Shaking::voltage_n(std::size_t side) const {
  return motor_n_s_m_ * voltage_m_s_[side];
}

}  // namespace plants::sixth

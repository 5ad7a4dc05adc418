#include "tests/benchmark/second_plant/odd_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants::second {

namespace {
constexpr double full_turn = 2.0 * std::numbers::pi;
}

OddForce::OddForce(const OddForceSpec& spec, Random random)
    : spec_(spec),
      random_(random),
      payload_friction_(spec.payload_friction),
      pump_phase_s_(random_.uniform(0.0, spec.pump_period_s)),
      gust_phase_s_(random_.uniform(0.0, spec.gust_period_s)) {
  if (spec_.seizing_drag_n_s_m > 0.0) next_seizing_s_ = random_.uniform(2.0, spec_.seizing_every_s);
}

void OddForce::step(double now_s, double acceleration_m_s2, double step_s) {
  if (now_s >= next_seizing_s_) {
    seizing_wheel_ = random_.chance(0.5) ? left_side : right_side;
    seizing_until_s_ = now_s + random_.uniform(0.4, 0.7);
    next_seizing_s_ = now_s + spec_.seizing_every_s * random_.uniform(0.5, 1.5);
  }
  if (spec_.payload_kg > 0.0) step_payload(acceleration_m_s2, step_s);
}

void OddForce::step_payload(double acceleration_m_s2, double step_s) {
  const double circular_1_s = full_turn * spec_.payload_hz;
  const double spring_n = spec_.payload_kg * circular_1_s * circular_1_s * payload_m_;
  payload_n_ = spring_n + payload_friction_.force_n(payload_m_s_, step_s);
  payload_m_s_ -= step_s * (acceleration_m_s2 + payload_n_ / spec_.payload_kg);
  payload_m_ += step_s * payload_m_s_;
}

double OddForce::pump_n(double now_s) const {
  if (spec_.pump_n == 0.0) return 0.0;
  const double stroke = std::sin(full_turn * (now_s + pump_phase_s_) / spec_.pump_period_s);
  return spec_.pump_n * std::tanh(3.0 * stroke);
}

double OddForce::gust_n(double now_s, double heading_rad) const {
  if (spec_.gust_n == 0.0) return 0.0;
  const double sweep = std::cos(full_turn * (now_s + gust_phase_s_) / spec_.gust_period_s);
  const double strength = std::pow(std::max(0.0, sweep), 4.0);
  return spec_.gust_n * strength * std::cos(heading_rad - spec_.gust_direction_rad);
}

double OddForce::seizing_n(std::size_t wheel, double now_s, double wheel_m_s) const {
  if (now_s >= seizing_until_s_ || wheel != seizing_wheel_) return 0.0;
  return -spec_.seizing_drag_n_s_m * wheel_m_s;
}

}  // namespace plants::second

#include "tests/benchmark/third_plant/odd_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants::third {

namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;

}  // namespace

OddForce::OddForce(const OddForceSpec& spec, double rim_mass_kg, Random random)
    : spec_(spec),
      rim_mass_kg_(rim_mass_kg),
      random_(random),
      hum_phase_rad_(random_.uniform(0.0, turn_rad)) {}

void OddForce::step(double now_s, double motor_m_s, double step_s) {
  if (spec_.gust_n > 0.0) step_gusts(now_s, step_s);
  if (spec_.load_share > 0.0) step_load(motor_m_s, step_s);
}

double OddForce::on_wheel_n(std::size_t wheel, double wheel_m_s, double now_s) const {
  double force_n = gust_n(wheel, wheel_m_s);
  force_n += spec_.hum_n * std::sin(turn_rad * spec_.hum_hz * now_s + hum_phase_rad_);
  const double spring_m_s2 = std::pow(turn_rad * spec_.load_hz, 2.0) * load_m_;
  return force_n + spec_.load_share * rim_mass_kg_ * (spring_m_s2 + stop_m_s2());
}

void OddForce::step_gusts(double now_s, double step_s) {
  constexpr double correlation_s = 0.5;
  if (now_s > blowing_until_s_) {
    blowing_ = !blowing_;
    blowing_until_s_ = now_s + (blowing_ ? random_.uniform(0.8, 3.0) : random_.uniform(1.0, 5.0));
  }
  const double share = step_s / correlation_s;
  for (double* part : {&push_, &turning_}) *part += -share * *part + random_.normal(std::sqrt(2.0 * share));
}

double OddForce::gust_n(std::size_t wheel, double wheel_m_s) const {
  if (!blowing_) return 0.0;
  constexpr double moving_m_s = 0.03;  // the brakes hold the robot at rest
  const double side = wheel == left_side ? -1.0 : 1.0;
  const double moving = std::min(1.0, std::abs(wheel_m_s) / moving_m_s);
  return spec_.gust_n * (0.75 * push_ + side * 0.66 * turning_) * moving;
}

double OddForce::stop_m_s2() const {
  constexpr double stop_m = 0.012;
  constexpr double stiffness_1_s2 = 9000.0;
  return stiffness_1_s2 * (load_m_ - std::clamp(load_m_, -stop_m, stop_m));
}

void OddForce::step_load(double motor_m_s, double step_s) {
  constexpr double damping_ratio = 0.05;
  constexpr double stop_damping_1_s = 20.0;
  const double circular_1_s = turn_rad * spec_.load_hz;
  const double carried_m_s2 = (motor_m_s - motor_before_m_s_) / step_s;
  motor_before_m_s_ = motor_m_s;
  double pull_m_s2 = circular_1_s * circular_1_s * load_m_ + 2.0 * damping_ratio * circular_1_s * load_m_s_;
  if (stop_m_s2() != 0.0) pull_m_s2 += stop_m_s2() + stop_damping_1_s * load_m_s_;
  load_m_s_ -= step_s * (carried_m_s2 + pull_m_s2);
  load_m_ += step_s * load_m_s_;
}

}  // namespace plants::third

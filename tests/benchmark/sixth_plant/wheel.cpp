#include "tests/benchmark/sixth_plant/wheel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants::sixth {

Wheel::Wheel(const Robot& robot, const Hidden& hidden, std::size_t side, bool engaged, Random& chance)
    : robot_(robot), hidden_(hidden), side_(side), angle_rad_(chance.uniform(0, 2 * std::numbers::pi)) {
  const double sign = hidden.details.sign;
  if (engaged) twist_m_ = hidden[Effect::backlash] / 2;
  const double half_mismatch = hidden[Effect::wheel_scale_mismatch] * sign / 2;
  size_share_ += side == left_side ? -half_mismatch : half_mismatch;
  if (hidden.has(Effect::distance_scale)) size_share_ *= 1 + hidden[Effect::distance_scale] * sign;
  if (hidden.has(Effect::acceleration_slip))
    most_push_n_ =
        (1 - hidden[Effect::acceleration_slip]) * robot.mass_kg / 2 * robot.top_m_s / robot.response_s * 0.6;
  if (hidden.has(Effect::pid_windup))
    most_pull_n_ = (1 - hidden[Effect::pid_windup]) * robot.motor_n_s_m * robot.top_m_s * 0.9;
}

double Wheel::wanted_voltage_m_s(double time_s, double duty_m_s) {
  const Details& details = hidden_.details;
  double voltage_m_s = duty_m_s * (robot_.gain * robot_.yield_n_s_m() / robot_.motor_n_s_m);
  if (hidden_.has(Effect::pid_windup)) {
    integral_m_s_ += (robot_.gain * duty_m_s - wheel_m_s_) * fine_step_s * 5.;
    voltage_m_s += integral_m_s_;
  }
  if (hidden_.has(Effect::gain_drift) && !details.heads())
    voltage_m_s *= 1 - hidden_[Effect::gain_drift] * (1 - std::exp(-time_s / details.warming_s));
  return voltage_m_s;
}

double Wheel::pull_n(double voltage_m_s) const {
  double back_share = 1;
  if (hidden_.has(Effect::direction_gain) && motor_m_s_ < 0)
    back_share = 1 + hidden_[Effect::direction_gain] * robot_.yield_n_s_m() / robot_.motor_n_s_m;
  double force_n = robot_.motor_n_s_m * (voltage_m_s - back_share * motor_m_s_);
  const bool brakes = force_n * motor_m_s_ < 0;
  if (hidden_.has(Effect::asymmetric_response) && brakes) force_n *= 1 - hidden_[Effect::asymmetric_response];
  return std::clamp(force_n, -most_pull_n_, most_pull_n_);
}

// Teeth push and never pull.
double Wheel::teeth_n() const {
  const double half_gap_m = hidden_[Effect::backlash] / 2;
  const double stiffness = robot_.gear_stiffness_n_m;
  const double damping_n = robot_.gear_damping_n_s_m * (motor_m_s_ - wheel_m_s_);
  if (half_gap_m <= 0) return stiffness * twist_m_ + damping_n;
  if (twist_m_ > half_gap_m) return std::max(0., stiffness * (twist_m_ - half_gap_m) + damping_n);
  if (twist_m_ < -half_gap_m) return std::min(0., stiffness * (twist_m_ + half_gap_m) + damping_n);
  return 0;
}

// Of a chipped tooth, once in each turn of its gear.
double Wheel::tooth_n() const {
  constexpr double pi = std::numbers::pi;
  constexpr double chipped_share = 0.18;  // of the turn
  double turns = rolled_m_ / (2 * pi * robot_.wheel_radius_m * robot_.gear_turns);
  turns -= std::floor(turns);
  if (turns >= chipped_share) return 0;
  return hidden_[Effect::chipped_tooth] * robot_.motor_n_s_m * robot_.top_m_s *
         std::sin(pi * turns / chipped_share) * std::tanh(motor_m_s_ / 0.02);
}

double Wheel::friction_n() const {
  constexpr double free_m_s = 0.012;
  double friction_n = 0;
  if (hidden_.has(Effect::coulomb_friction))
    friction_n += hidden_[Effect::coulomb_friction] * robot_.top_m_s * robot_.yield_n_s_m();
  if (hidden_.has(Effect::stiction))
    friction_n += hidden_[Effect::stiction] * robot_.top_m_s * robot_.gain * robot_.yield_n_s_m() *
                  std::exp(-(motor_m_s_ / free_m_s) * (motor_m_s_ / free_m_s));
  return friction_n;
}

void Wheel::turn_motor(double time_s, double motor_n) {
  twist_m_ += (motor_m_s_ - wheel_m_s_) * fine_step_s;
  pressed_n_ = teeth_n();
  double left_over_n = motor_n - pressed_n_;
  if (hidden_.has(Effect::gain_drift) && hidden_.details.heads()) {
    const double drift = hidden_[Effect::gain_drift];
    left_over_n -= robot_.yield_n_s_m() * drift / (1 - drift) *
                   std::exp(-time_s / hidden_.details.warming_s) * motor_m_s_;
  }
  if (hidden_.has(Effect::chipped_tooth) && side_ == left_side) left_over_n -= tooth_n();
  const double friction = friction_n();
  motor_m_s_ += left_over_n * fine_step_s / robot_.motor_kg;
  if (friction <= 0) return;
  const double braked_m_s = friction * fine_step_s / robot_.motor_kg;
  // It holds if it can.
  if (std::abs(motor_m_s_) <= braked_m_s)
    motor_m_s_ = 0;
  else
    motor_m_s_ -= std::copysign(braked_m_s, motor_m_s_);
}

double Wheel::size_share() const {
  const std::size_t bad_side = hidden_.details.heads() ? left_side : right_side;
  if (!hidden_.has(Effect::wheel_eccentricity) || side_ != bad_side) return size_share_;
  return size_share_ * (1 + hidden_[Effect::wheel_eccentricity] * std::cos(angle_rad_));
}

double Wheel::push_n(double ground_m_s, double track_m, double more_drag_n_s_m) {
  const Robot& bot = robot_;
  const double slip_m_s = wheel_m_s_ * size_share() - ground_m_s;
  // Implicit, as a tyre is too stiff for the fine step.
  const double per_kg = 1 / bot.wheel_kg + 1 / bot.mass_kg + track_m * track_m / 4 / bot.yaw_inertia_kg_m2;
  const double softened = 1 + fine_step_s * bot.creep_n_s_m * per_kg;
  const double force_n = std::clamp(bot.creep_n_s_m * slip_m_s / softened, -most_push_n_, most_push_n_);
  const double drag_n_s_m = bot.drag_n_s_m + more_drag_n_s_m;
  wheel_m_s2_ = (pressed_n_ - drag_n_s_m * wheel_m_s_ - force_n) / bot.wheel_kg;
  return force_n;
}

void Wheel::roll() {
  wheel_m_s_ += wheel_m_s2_ * fine_step_s;
  rolled_m_ += wheel_m_s_ * fine_step_s;
  angle_rad_ += wheel_m_s_ / robot_.wheel_radius_m * fine_step_s;
}

}  // namespace plants::sixth

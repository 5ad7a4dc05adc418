#include "tests/benchmark/sixth_plant/body.hpp"

#include <cmath>
#include <numbers>

namespace plants::sixth {

namespace {

constexpr double half_turn_rad = std::numbers::pi;

double rightward(std::size_t side) {
  return side == right_side ? 1 : -1;
}

}  // namespace

Body::Body(const Robot& robot, const Hidden& hidden, const Pose& start, Random& chance)
    : robot_(robot),
      hidden_(hidden),
      castor_(robot, hidden),
      track_m_(robot.wheel_base_m * (1 + hidden[Effect::effective_track] * hidden.details.sign)),
      floor_yield_n_s_m_(robot.floor_yield_n_s_m()),
      fan_phase_rad_(chance.uniform(0, 2 * half_turn_rad)),
      pose_(start) {}

double Body::ground_m_s(std::size_t side) const {
  return forward_m_s_ + rightward(side) * turn_rad_s_ * track_m_ / 2;
}

bool Body::on_patch(std::size_t side) const {
  const Details& details = hidden_.details;
  const double x_m = pose_.x_m - rightward(side) * std::sin(pose_.heading_rad) * track_m_ / 2;
  const double y_m = pose_.y_m + rightward(side) * std::cos(pose_.heading_rad) * track_m_ / 2;
  return std::abs(x_m - details.patch_x_m) < details.patch_half_m &&
         std::abs(y_m - details.patch_y_m) < details.patch_half_m * details.patch_shape;
}

double Body::more_drag_n_s_m(std::size_t side) const {
  const auto taking = [this](double share) { return robot_.yield_n_s_m() * share / (1 - share); };
  double drag_n_s_m = 0;
  if (hidden_.has(Effect::surface_patch) && on_patch(side))
    drag_n_s_m += taking(hidden_[Effect::surface_patch]);
  if (hidden_.has(Effect::payload_flips) && load_side_ == rightward(side))
    drag_n_s_m += taking(hidden_[Effect::payload_flips]);
  return drag_n_s_m;
}

double Body::forward_n(double time_s) const {
  constexpr double weight_m_s2 = 9.81;
  constexpr double fan_period_s = 7;
  double force_n = 0;
  if (hidden_.has(Effect::turn_speed_loss))
    force_n -= hidden_[Effect::turn_speed_loss] * 2 * floor_yield_n_s_m_ * std::abs(turn_rad_s_) *
               std::tanh(forward_m_s_ / 0.02);
  if (hidden_.has(Effect::floor_slope))
    force_n -= robot_.mass_kg * weight_m_s2 * std::sin(hidden_[Effect::floor_slope] * half_turn_rad / 180) *
               std::cos(pose_.heading_rad - hidden_.details.angle_rad);
  if (hidden_.has(Effect::oscillating_fan))
    force_n += hidden_[Effect::oscillating_fan] * robot_.top_m_s * 2 * floor_yield_n_s_m_ *
               std::sin(2 * half_turn_rad * time_s / fan_period_s + fan_phase_rad_) *
               std::cos(pose_.heading_rad);
  return force_n;
}

double Body::yaw_n_m(double rims_m_s) {
  double moment_n_m = 0;
  if (hidden_.has(Effect::turn_scrub))
    moment_n_m -= hidden_[Effect::turn_scrub] / 3 * floor_yield_n_s_m_ * track_m_ * track_m_ / 2 *
                  turn_rad_s_ * std::abs(turn_rad_s_);
  if (hidden_.has(Effect::yaw_bias))
    moment_n_m += hidden_[Effect::yaw_bias] * hidden_.details.sign * floor_yield_n_s_m_ * track_m_ *
                  track_m_ / 2 * std::tanh(rims_m_s / 0.04);
  if (hidden_.has(Effect::caster_kick))
    moment_n_m += castor_.step(hidden_[Effect::caster_kick] * floor_yield_n_s_m_ * track_m_ * track_m_ / 2,
                               forward_m_s_, turn_rad_s_);
  return moment_n_m;
}

void Body::step(double time_s, const PerWheel<double>& push_n, double rims_m_s, double shaken_m_s,
                double shaken_rad_s) {
  constexpr double sharp_rad_s = 0.7;
  const double ahead_n = push_n[left_side] + push_n[right_side] + forward_n(time_s);
  const double aside_n_m = (push_n[right_side] - push_n[left_side]) * track_m_ / 2 + yaw_n_m(rims_m_s);
  forward_m_s_ += ahead_n / robot_.mass_kg * fine_step_s;
  turn_rad_s_ += aside_n_m / robot_.yaw_inertia_kg_m2 * fine_step_s;
  if (std::abs(turn_rad_s_) > sharp_rad_s) load_side_ = turn_rad_s_ > 0 ? 1 : -1;
  const double seen_m_s = forward_m_s_ + shaken_m_s;
  const double seen_rad_s = turn_rad_s_ + shaken_rad_s;
  const double halfway_rad = pose_.heading_rad + seen_rad_s * fine_step_s / 2;
  pose_.x_m += seen_m_s * std::cos(halfway_rad) * fine_step_s;
  pose_.y_m += seen_m_s * std::sin(halfway_rad) * fine_step_s;
  pose_.heading_rad += seen_rad_s * fine_step_s;
}

}  // namespace plants::sixth

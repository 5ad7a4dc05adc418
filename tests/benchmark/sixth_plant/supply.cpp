#include "tests/benchmark/sixth_plant/supply.hpp"

#include <algorithm>
#include <cmath>

namespace plants::sixth {

Supply::Supply(const Robot& robot, const Hidden& hidden, double duration_s, Random& chance)
    : robot_(robot),
      hidden_(hidden),
      duration_s_(duration_s),
      charge_share_(1 - (hidden.has(Effect::voltage_sag)
                             ? chance.uniform(0, hidden[Effect::voltage_sag] * 0.6)
                             : chance.uniform(0, 0.03))),
      battery_share_(charge_share_) {}

double Supply::weakened(double asked_m_s, std::size_t side) const {
  constexpr double most_droop = 0.6;
  double left_over = asked_m_s;
  if (hidden_.has(Effect::voltage_sag)) left_over *= battery_share_;
  if (hidden_.has(Effect::supply_hiccup)) left_over *= 1 - std::min(most_droop, droop_share_);
  if (hidden_.has(Effect::thermal_cutback) && side == left_side && hot_)
    left_over *= 1 - hidden_[Effect::thermal_cutback];
  return left_over;
}

void Supply::step(double time_s, const PerWheel<double>& force_n, double left_m_s) {
  const double current = (std::abs(force_n[left_side]) + std::abs(force_n[right_side])) /
                         (2 * robot_.motor_n_s_m * robot_.top_m_s);
  drawn_share_ += (current - drawn_share_) * fine_step_s / 0.02;
  if (hidden_.has(Effect::voltage_sag)) {
    const double sag = hidden_[Effect::voltage_sag];
    battery_share_ = charge_share_ - sag * (0.75 * time_s / duration_s_) - 0.25 * sag * drawn_share_;
  }
  if (hidden_.has(Effect::supply_hiccup)) {
    const double asked = hidden_[Effect::supply_hiccup] * std::max(0., current - 0.12) * 3;
    droop_share_ += (asked - droop_share_) * fine_step_s / 0.4;
  }
  if (hidden_.has(Effect::thermal_cutback)) {
    const double share = left_m_s / robot_.top_m_s;
    heat_ += (share * share - heat_) * fine_step_s / 6.;
    if (heat_ > 1.1 * hidden_.details.usual_heat) hot_ = true;
    if (heat_ < 0.8 * hidden_.details.usual_heat) hot_ = false;
  }
}

double Supply::battery_v(double time_s) const {
  const double share = hidden_.has(Effect::voltage_sag)
                           ? battery_share_
                           : charge_share_ - 0.02 * time_s / duration_s_ - 0.01 * drawn_share_;
  return robot_.battery_v * share;
}

}  // namespace plants::sixth

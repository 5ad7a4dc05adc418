#include "model/gap/candidates/travel_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wheelwright::gap {
namespace {

double first_heading_rad(const DriveLog& log) {
  for (const auto& sample : log.samples) {
    if (sample.reference_theta_rad) return *sample.reference_theta_rad;
  }
  return 0.0;
}

// What the wheels rolled from one row to the next.
WheelPair rolled_m(const DriveLog& log, std::size_t row) {
  const DriveSample& from = log.samples[row];
  const DriveSample& to = log.samples[row + 1];
  if (log.has_ticks()) {
    if (!from.ticks || !to.ticks || to.counter_reset) return {};
    return {static_cast<double>(to.ticks->left - from.ticks->left) * log.metres_per_tick->left,
            static_cast<double>(to.ticks->right - from.ticks->right) * log.metres_per_tick->right};
  }
  const double duration_s = to.t_s - from.t_s;
  return {from.command_m_s.left * duration_s, from.command_m_s.right * duration_s};
}

}  // namespace

void TravelDirections::add(const DriveLog& log) {
  constexpr double turn_rad = 2.0 * std::numbers::pi;
  double heading_rad = first_heading_rad(log);
  for (std::size_t row = 0; row + 1 < log.samples.size(); ++row) {
    const Twist step = twist_of_wheels(rolled_m(log, row), log.wheel_base_m);
    heading_rad += step.w_rad_s;
    if (step.v_m_s == 0.0) continue;
    const double direction_rad = step.v_m_s > 0.0 ? heading_rad : heading_rad + std::numbers::pi;
    const double turns = direction_rad / turn_rad;
    const auto sector = static_cast<std::size_t>(static_cast<double>(sectors) * (turns - std::floor(turns)));
    seen_[std::min(sector, sectors - 1)] = true;
  }
}

bool TravelDirections::all_round() const {
  std::size_t empty = 0;  // sectors in a row
  for (std::size_t i = 0; i < 2 * sectors; ++i) {
    empty = seen_[i % sectors] ? 0 : empty + 1;
    if (empty + 1 >= sectors / 2) return false;
  }
  return true;
}

}  // namespace wheelwright::gap

#include "drivers/simulation/wheel_controller.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wheelwright::simulation {
namespace {

// Create 2 Open Interface page 31: the wheel that the firmware is written for.
constexpr double nominal_wheel_diameter_m = 0.072;
// Below this no command moves a wheel on a robot whose commands act in steps.
constexpr double staircase_dead_zone_m_s = 0.010;

double sign(double value) {
  return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0);
}

}  // namespace

WheelController::WheelController(const FirmwareConfig& firmware, const EncoderConfig& encoder)
    : config_(firmware),
      metres_per_count_(std::numbers::pi * nominal_wheel_diameter_m / encoder.counts_per_revolution),
      counts_per_rad_(encoder.counts_per_revolution / (2.0 * std::numbers::pi)) {
  config_.command_delay_ticks =
      std::clamp(firmware.command_delay_ticks, 0, static_cast<int>(longest_delay_ticks));
}

void WheelController::command_speed(double speed_m_s) {
  newest_ = {true, std::clamp(speed_m_s, -config_.speed_limit_m_s, config_.speed_limit_m_s)};
}

void WheelController::command_duty(double duty) {
  newest_ = {false, std::clamp(duty, -1.0, 1.0)};
}

void WheelController::cut() {
  newest_ = {false, 0.0};
  delayed_.fill(newest_);
  current_ = newest_;
  duty_ = 0.0;
  integral_v_ = 0.0;
}

double WheelController::acted_on_speed_m_s(double commanded_m_s) const {
  if (!config_.staircase) return commanded_m_s;
  const double size_m_s = std::abs(commanded_m_s);
  if (size_m_s <= staircase_dead_zone_m_s) return 0.0;
  const double step_m_s = metres_per_count_ / config_.tick_s;
  return std::copysign(step_m_s * (1.0 + std::floor((size_m_s - staircase_dead_zone_m_s) / step_m_s)),
                       commanded_m_s);
}

double WheelController::measured_distance_m(double angle_rad) const {
  const double counts = angle_rad * counts_per_rad_;
  return metres_per_count_ * (config_.whole_counts ? std::floor(counts) : counts);
}

void WheelController::tick(double angle_rad, double supply_v) {
  const auto delay = static_cast<std::size_t>(config_.command_delay_ticks);
  for (std::size_t i = delay; i > 0; --i) delayed_[i] = delayed_[i - 1];
  delayed_[0] = newest_;
  current_ = delayed_[delay];

  const double distance_m = measured_distance_m(angle_rad);
  const double speed_m_s = (distance_m - last_distance_m_) / config_.tick_s;
  const double acceleration_m_s2 = (speed_m_s - last_speed_m_s_) / config_.tick_s;
  last_distance_m_ = distance_m;
  last_speed_m_s_ = speed_m_s;
  if (!current_.is_speed) {
    duty_ = current_.value;
    integral_v_ = 0.0;
    return;
  }
  const double wanted_m_s = acted_on_speed_m_s(current_.value);
  if (wanted_m_s == 0.0 && speed_m_s == 0.0) integral_v_ = 0.0;  // at rest it does not hold the wheel
  const double error_m_s = wanted_m_s - speed_m_s;
  const double voltage_v = config_.feed_forward_v_s_per_m * wanted_m_s +
                           config_.feed_forward_offset_v * sign(wanted_m_s) +
                           config_.proportional_v_s_per_m * error_m_s -
                           config_.derivative_v_s2_per_m * acceleration_m_s2 + integral_v_;
  const double reference_v =
      config_.voltage_compensation ? std::max(supply_v, 1.0) : config_.nominal_voltage_v;
  const double wanted_duty = voltage_v / reference_v;
  duty_ = std::clamp(wanted_duty, -1.0, 1.0);
  const bool winding_up = duty_ != wanted_duty && error_m_s * wanted_duty > 0.0;
  if (!winding_up) integral_v_ += config_.integral_v_per_m * error_m_s * config_.tick_s;
  if (wanted_m_s == 0.0 && speed_m_s == 0.0) duty_ = 0.0;
}

int WheelController::commanded_sign() const {
  return static_cast<int>(sign(current_.value));
}

}  // namespace wheelwright::simulation

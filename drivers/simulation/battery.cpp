#include "drivers/simulation/battery.hpp"

#include <algorithm>

namespace wheelwright::simulation {

Battery::Battery(const BatteryConfig& config)
    : config_(config),
      charge_mah_(config.charge * config.capacity_mah),
      current_a_(config.idle_current_a),
      voltage_v_(terminal_voltage_v()) {}

void Battery::draw(double motor_current_a, double duration_s) {
  current_a_ = config_.idle_current_a + motor_current_a;
  constexpr double mah_per_ampere_second = 1000.0 / 3600.0;
  charge_mah_ = std::max(0.0, charge_mah_ - current_a_ * duration_s * mah_per_ampere_second);
  voltage_v_ = terminal_voltage_v();
}

double Battery::terminal_voltage_v() const {
  const double fraction = charge_mah_ / config_.capacity_mah;
  const double open_circuit_v =
      config_.empty_voltage_v + fraction * (config_.full_voltage_v - config_.empty_voltage_v);
  return std::max(0.0, open_circuit_v - config_.internal_resistance_ohm * current_a_);
}

}  // namespace wheelwright::simulation

// The battery: an open-circuit voltage that falls with its charge, behind an internal resistance.
#pragma once

#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class Battery {
 public:
  explicit Battery(const BatteryConfig& config);

  // Draws the motors' current for a time; the idle current is added.
  void draw(double motor_current_a, double duration_s);

  double voltage_v() const { return voltage_v_; }  // at the terminals
  double current_a() const { return current_a_; }  // out of the battery
  double charge_mah() const { return charge_mah_; }
  double capacity_mah() const { return config_.capacity_mah; }

 private:
  double terminal_voltage_v() const;

  BatteryConfig config_;
  double charge_mah_;
  double current_a_;
  double voltage_v_;
};

}  // namespace wheelwright::simulation

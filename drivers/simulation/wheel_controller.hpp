// The firmware's wheel-speed controller: once per tick from a wanted speed and the encoder to a motor duty.
//
// Proportional, integral and derivative action on the distance counted per tick, on top of a feed-forward of
// the wanted speed. It has no model of the wheel: what it reaches depends on its gains, friction and the
// battery. In PWM mode it is bypassed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class WheelController {
 public:
  WheelController(const FirmwareConfig& firmware, const EncoderConfig& encoder);

  // From the next tick on (and the configured delay later): a speed, or a duty from -1 to 1.
  void command_speed(double speed_m_s);
  void command_duty(double duty);
  // Motor off at once, without the delay.
  void cut();

  // One tick. `angle_rad` is what the encoder has turned in all, `supply_v` the measured battery voltage.
  void tick(double angle_rad, double supply_v);

  double duty() const { return duty_; }
  // The sign of what is being commanded: -1, 0 or 1.
  int commanded_sign() const;

 private:
  struct Command {
    bool is_speed = true;
    double value = 0.0;  // m/s or duty
  };
  static constexpr std::size_t longest_delay_ticks = 40;

  double acted_on_speed_m_s(double commanded_m_s) const;
  double measured_distance_m(double angle_rad) const;

  FirmwareConfig config_;
  double metres_per_count_;  // as the firmware believes: 72 mm wheels
  double counts_per_rad_;
  std::array<Command, longest_delay_ticks + 1> delayed_{};
  Command newest_;
  Command current_;
  double duty_ = 0.0;
  double integral_v_ = 0.0;
  double last_distance_m_ = 0.0;
  double last_speed_m_s_ = 0.0;
};

}  // namespace wheelwright::simulation

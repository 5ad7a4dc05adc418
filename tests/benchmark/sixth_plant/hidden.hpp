// What can be hidden in the robot, and how large.
#pragma once

#include <array>
#include <cstddef>

namespace plants::sixth {

// First the names of the contract, then what has no name there. The order gives each case its seed.
enum class Effect {
  dead_zone,
  saturation,
  rate_limit,
  command_quantization,
  transport_delay,
  coulomb_friction,
  stiction,
  gain_curve,
  direction_gain,
  asymmetric_response,
  voltage_sag,
  gain_drift,
  backlash,
  wheel_eccentricity,
  wheel_scale_mismatch,
  effective_track,
  distance_scale,
  acceleration_slip,
  turn_speed_loss,
  turn_scrub,
  yaw_bias,
  floor_slope,
  surface_patch,
  caster_kick,
  lever_arm,
  encoder_dropout,
  supply_hiccup,
  turn_accel_clip,
  gear_hysteresis,
  mast_sway,
  link_stalls,
  chipped_tooth,
  pid_windup,
  oscillating_fan,
  thermal_cutback,
  stamp_sawtooth,
  payload_flips,
  driver_sleep,
};

inline constexpr auto effect_count = static_cast<std::size_t>(Effect::driver_sleep) + 1;

// What an effect has besides its size.
struct Details {
  double coin = 0.0;  // 0 to 1, for one of two ways
  double warming_s = 1.0;
  double sign = 1.0;
  double patch_x_m = 0.0;
  double patch_y_m = 0.0;
  double patch_half_m = 0.0;
  double patch_shape = 1.0;  // extent in y for one in x
  double angle_rad = 0.0;
  double usual_heat = 0.0;  // mean square of the commands of the drives, in shares of full duty

  [[nodiscard]] bool heads() const { return coin > 0.5; }
  [[nodiscard]] double mast_hz() const { return warming_s * 0.02 + 0.5; }
};

struct Hidden {
  std::array<double, effect_count> sizes{};  // each in a unit of its own, 0 = absent
  Details details;

  double& operator[](Effect effect) { return sizes[static_cast<std::size_t>(effect)]; }
  double operator[](Effect effect) const { return sizes[static_cast<std::size_t>(effect)]; }
  [[nodiscard]] bool has(Effect effect) const { return (*this)[effect] != 0.0; }
};

}  // namespace plants::sixth

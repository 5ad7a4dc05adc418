// The robot of the gap benchmark in physical numbers. As it stands it is linear: two motors on voltage, lags,
// a delay, a body with mass and inertia. Every number below "hidden" is absent (zero, or infinite for a
// limit) until an effect is hidden.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "model/geometry/pose.hpp"
#include "tests/support/gap_plant/hidden_effect.hpp"

namespace wheelwright::test {

struct PlantParameters {
  double wheel_base_m = 0.258;
  double wheel_radius_m = 0.036;
  double metres_per_tick = 0.000444;

  // Drive. `response_s` is the time constant of a wheel without a speed controller.
  double delay_s = 0.03;
  double amplifier_lag_s = 0.02;
  double response_s = 0.075;
  double yaw_response_ratio = 0.9;  // time constant of turning over that of going straight
  double viscous_share = 0.35;      // of the damping; the rest is the motor's back-EMF
  WheelPair motor_gain{1.0, 1.0};
  double controller_gain = 0.0;         // of the wheel's speed controller; 0: none
  double controller_integral_hz = 0.0;  // and its leaky integral
  double controller_leak_s = 0.1;

  // Noise.
  double speed_noise_m_s = 0.0006;  // of the rim, from an unsteady load
  double slip_noise_share = 0.002;  // of the distance on the floor, over `slip_noise_length_m`
  double slip_noise_length_m = 0.05;
  double reference_noise_m = 0.0015;
  double reference_noise_rad = 0.003;
  double gyro_noise_rad_s = 0.01;
  double gyro_bias_rad_s = 0.004;
  double battery_noise_v = 0.015;

  double battery_full_v = 16.4;
  double battery_fall_share = 0.03;  // over a charge, with a regulated drive, on which it does not act

  // Hidden: command and amplifier.
  static constexpr double none = std::numeric_limits<double>::infinity();
  double firmware_threshold_m_s = 0.0;  // commands below it are not passed on
  double crossover_m_s = 0.0;           // the output stage gives nothing below it, and lacks it above
  double command_step_m_s = 0.0;
  double extra_delay_s = 0.0;
  double rail_m_s = none;
  double slew_m_s2 = none;
  double supply_fall_share = 0.0;  // of the drive, over the whole charge
  double cross_talk = 0.0;
  double history_gain = 0.0;

  // Hidden: motor and gear.
  double sliding_friction_m_s = 0.0;  // forces in m/s: the speed that they take without a controller
  double breakaway_friction_m_s = 0.0;
  double windage_share = 0.0;  // lost at 0.3 m/s
  double grease_share = 0.0;   // lost at very low speed
  double brush_advance = 0.0;  // forward less reverse gain
  double missing_brake_share = 0.0;
  double warm_loss_share = 0.0;
  double warming_s = 25.0;
  double play_m = 0.0;
  double eccentricity = 0.0;
  double resonance_share = 0.0;
  double clock_cogging_m_s = 0.0;

  // Hidden: floor and body. `upset_loads_motors`: what hampers the body acts as a force on the motors, so
  // that the encoders see it; else the wheels slip by that much.
  bool upset_loads_motors = false;
  WheelPair rolling{1.0, 1.0};  // metres on the floor for a metre of the rim
  double track_share = 0.0;
  double hop_share = 0.0;    // lost at 3 m/s^2
  double turn_drag_m = 0.0;  // m/s for a rad/s
  double scrub_share = 0.0;  // lost at 2 rad/s
  double yaw_bias_rad_s = 0.0;
  double slope_m_s = 0.0;
  double uphill_rad = 0.0;  // heading that goes straight up
  double patch_share = 0.0;
  Pose patch;  // middle and heading of a rectangle
  double patch_length_m = 1.6;
  double patch_width_m = 1.1;
  double caster_kick_rad = 0.0;
  bool caster_turns_on = false;  // round and round; else to and fro over the same side

  // Hidden: sensors.
  Pose measured_point;         // where the reference looks, from the middle of the axle
  double dropout_share = 0.0;  // of the time
  double dropout_s = 0.25;     // mean length
};

// The robot of a seed: lags, delay and noise vary by tens of per cent, motor gains by a few per cent.
PlantParameters random_robot(std::uint64_t seed);

// Puts an effect of a size into the robot. Where nature has several ways (a dead zone in the firmware or in
// the output stage) the seed chooses; the way chosen is returned in a few words. `encoders_only` says that
// nothing else is logged, so that an effect of the body has to act on the motors to be in the data at all.
std::string hide(PlantParameters& robot, const HiddenEffect& effect, double size, std::uint64_t seed,
                 bool encoders_only);

}  // namespace wheelwright::test

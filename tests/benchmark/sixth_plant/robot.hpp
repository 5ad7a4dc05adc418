// A small educational robot: two brushed motors behind gears of 60 to 1, driven in open loop by a duty that
// is scaled to metres per second, rubber tyres that creep, a castor behind, and a camera overhead. Motors
// count as masses at the rims of their wheels.
#pragma once

#include "tests/benchmark/plants/random.hpp"

namespace plants::sixth {

inline constexpr double fine_step_s = 0.0005;

// Noise with a size and the time after which it has forgotten itself.
struct NoiseSpec {
  double sigma = 0.0;
  double memory_s = 1.0;
};

struct NoiseSpecs {
  NoiseSpec fast_m_s;        // of the load on a motor
  NoiseSpec slow_m_s;        // of the load on a motor
  double loop_m_s = 0.0;     // of the voltage, without memory
  NoiseSpec turn_rad_s;      // of the contact with the floor
  NoiseSpec forward_m_s;     // of the contact with the floor
  double seen_m = 0.0;       // of the camera
  double seen_rad = 0.0;     // of the camera
  double seen_slow_m = 0.0;  // of the camera, what passes in some dozens of rows
};

struct Robot {
  double wheel_base_m = 0.0;
  double top_m_s = 0.0;
  double gain = 1.0;         // speed for a command
  double response_s = 0.0;   // of a motor to its voltage
  double smoothing_s = 0.0;  // of the commands
  double mass_kg = 0.0;
  double yaw_inertia_kg_m2 = 0.0;
  double motor_kg = 0.0;
  double wheel_kg = 0.0;
  double motor_n_s_m = 0.0;  // force of a motor for a speed that is missing
  double drag_n_s_m = 0.0;   // of a wheel
  double gear_stiffness_n_m = 3e4;
  double gear_damping_n_s_m = 60.0;
  double creep_n_s_m = 0.0;  // force of a tyre for a speed of slip
  double wheel_radius_m = 0.0;
  double metres_per_tick = 0.0;
  double latency_s = 0.0;
  double period_s = 0.0;
  bool jitters = false;
  NoiseSpecs noise;
  double battery_v = 0.0;
  double castor_arm_m = 0.0;
  double castor_trail_m = 0.0;
  double gear_turns = 0.0;  // turns of a wheel in which the last but one gear turns once

  // Force at the rim for a speed that is taken away.
  [[nodiscard]] double yield_n_s_m() const { return motor_n_s_m + drag_n_s_m; }
  // Speed over the floor for a force at the rim.
  [[nodiscard]] double floor_yield_n_s_m() const { return 1 / (1 / yield_n_s_m() + 1 / creep_n_s_m); }
};

// A robot in which nothing is hidden.
Robot random_robot(Random& random);

}  // namespace plants::sixth

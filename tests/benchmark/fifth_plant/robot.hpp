// A delivery platform for corridors: two driven wheels in the middle, castors in front and behind, geared
// direct current motors, a motor driver with a loop of its own, and a computer that sends it wheel speeds.
// All quantities of motor and gear are seen from the wheel's side of the gear.
#pragma once

#include <limits>
#include <vector>

#include "tests/benchmark/plants/wheels.hpp"

namespace plants::fifth {

inline constexpr double fine_step_s = 0.0005;
inline constexpr double no_limit = std::numeric_limits<double>::infinity();

// What the computer on board makes of commands.
struct FirmwareSpec {
  double delay_s = 0.02;
  double smoothing_s = 0.03;       // of the wanted speed, while it rises in size
  double smoothing_down_s = 0.03;  // and while it falls
  double threshold_m_s = 0.0;      // commands below it count as zero
  double step_m_s = 0.0;           // resolution of the link to the driver
  double fastest_m_s = no_limit;   // of a wheel
  double ramp_m_s2 = no_limit;
  double trim_rad_s = 0.0;     // added to the turn rate while driving
  double stall_every_s = 0.0;  // the radio link stands still now and then; 0 = never
  double stall_s = 0.0;
  double hunting_m_s = 0.0;  // a heading hold that swings while driving
  double hunting_period_s = 1.0;
};

// What the motor driver does to the voltage that its loop asks for.
struct DriverSpec {
  double dead_v = 0.0;
  double bend = 0.0;  // share of the gain that is lost at full voltage
  double full_v = 24.0;
  double limit_v = no_limit;
  double limit_a = no_limit;
  bool brakes = true;            // no: the current cannot oppose the motion
  bool follows_battery = false;  // no: measures the battery and makes up for it
  double foldback_share = 1.0;   // of the voltage, while hot
  double foldback_heat_v2_s = no_limit;
  double foldback_cooling_s = 10.0;
  double brake_release_s = 0.0;  // of the parking brake, which falls in after a stop; 0 = there is none
};

// Feed-forward of voltage with a proportional part, or a proportional-integral loop around the current.
struct LoopSpec {
  bool integral = false;
  double period_s = 0.002;
  double proportional = 0.0;  // volts or amperes for a rad/s
  double integral_per_s = 0.0;
};

struct MotorSpec {
  double constant_v_s = 1.8;   // also newton metres for an ampere
  double reverse_share = 1.0;  // of the constant when running backwards
  double resistance_ohm = 2.0;
  double inductance_h = 0.002;
  double inertia_kg_m2 = 0.012;
  double disturbance_n_m = 0.0;
  double disturbance_memory_s = 0.2;
};

struct GearSpec {
  double viscous_n_m_s = 0.05;
  double cold_viscous_n_m_s = 0.0;  // more while the grease is cold
  double warming_s = 30.0;
  double quadratic_n_m_s2 = 0.0;
  double dry_n_m = 0.0;
  double breakaway_n_m = 0.0;
  double stribeck_rad_s = 0.1;
  double resonance_n_m = 0.0;  // drag about one speed
  double resonance_rad_s = 5.0;
  double resonance_width_rad_s = 0.5;
  double gap_rad = 0.0;
  double stiffness_n_m = 500.0;
  double damping_n_m_s = 0.6;
  double runout = 0.0;  // eccentric last wheel of the gear
  double runout_phase_rad = 0.0;
};

struct WheelSpec {
  double said_radius_m = 0.075;  // that firmware and counters go by
  double radius_m = 0.075;
  double inertia_kg_m2 = 0.004;
  double drag_n_m = 0.0;  // dry, behind the gear
  double eccentricity = 0.0;
  double eccentricity_phase_rad = 0.0;
  double leak = 0.0;  // share of the radius that is lost in the end
  double leak_s = 60.0;
  double flat_depth = 0.0;  // share of the radius, at two opposite places
  double flat_width_rad = 0.25;
  double borne_n = 0.0;             // weight that has to be lifted out of a flat
  double hub_limit_n_m = no_limit;  // beyond it the hub turns on its shaft
  double hub_jump_rad = 0.0;
};

struct SideSpec {
  DriverSpec driver;
  LoopSpec loop;
  MotorSpec motor;
  GearSpec gear;
  WheelSpec wheel;
};

struct Patch {
  double from_x_m = 0.0;
  double to_x_m = 0.0;
  double from_y_m = 0.0;
  double to_y_m = 0.0;
  double drag_n_s_m = 0.0;  // on each wheel
};

struct FloorSpec {
  double grip_n = 400.0;              // what a wheel can transmit
  double slip_stiffness_n = 12000.0;  // force for a slip of one
  double relaxation_m = 0.03;
  double roughness = 0.0;  // of the rolled radius
  double roughness_memory_s = 0.3;
  double slope_rad = 0.0;
  double uphill_rad = 0.0;  // heading
  std::vector<Patch> patches;
  double joint_every_m = 0.0;  // of tiles, along x; 0 = none
  double joint_width_m = 0.02;
  double joint_n = 0.0;
};

// What acts on the body.
struct BodySpec {
  double turn_drag_n_s = 0.0;  // against the motion, for a rad/s
  double scrub_n_m_s2 = 0.0;   // yaw moment against the square of the turn rate
  double brush_n_m = 0.0;      // yaw moment of a brush that runs while driving
  double swivel_n_m = 0.0;     // friction in the swivel of the front castor
  double swivel_trail_m = 0.035;
  double swivel_x_m = 0.22;
  double swivel_lean = 0.2;
  double load_kg = 0.0;  // that slides in the tray
  double load_play_m = 0.03;
  double load_friction = 0.03;
  double turret_kg_m2 = 0.0;  // a mast that turns to and fro by itself
  double turret_every_s = 5.0;
  double tether_n_m = 0.0;  // pull of a cable, for each metre beyond its length
  double tether_length_m = 1.0;
};

struct BatterySpec {
  double full_v = 26.0;
  double nominal_v = 25.0;
  double fall_v_s = 0.002;
  double fall_between_v = 0.1;  // from one run to the next
  double resistance_ohm = 0.05;
  double noise_v = 0.01;
};

struct EncoderSpec {
  double metres_per_tick = 0.0003;  // that the wheels roll; as the log says
  double dropout_every_s = 0.0;     // 0 = never
  double dropout_s = 0.0;
  double crosstalk = 0.0;  // share of the left wheel's fast edges that the right counter sees
  double crosstalk_from_m_s = 0.2;
};

struct TrackerSpec {
  double marker_x_m = 0.0;
  double marker_y_m = 0.0;
  double latency_s = 0.02;
  double smoothing_s = 0.0;
  double slow_noise_m = 0.0;  // that smoothing has left
  double iron_rad = 0.0;      // error of the heading, once a turn
  double iron_phase_rad = 0.0;
  double iron_twice_rad = 0.0;  // and twice a turn
};

struct Robot {
  double mass_kg = 28.0;
  double yaw_inertia_kg_m2 = 1.1;
  double wheel_base_m = 0.42;       // between the contacts
  double said_wheel_base_m = 0.42;  // in the log
  double top_m_s = 0.7;
  double period_s = 0.02;  // of the log
  double jitter_s = 0.0;
  double stamp_noise_s = 0.0;
  FirmwareSpec firmware;
  PerWheel<SideSpec> sides;
  FloorSpec floor;
  BodySpec body;
  BatterySpec battery;
  EncoderSpec encoder;
  TrackerSpec tracker;
};

}  // namespace plants::fifth

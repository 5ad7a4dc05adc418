// What a simulated robot is made of: every part and every imperfection as a physical number.
//
// A plain struct whose defaults are a robot without imperfections on an empty, endless floor. Where a number
// is an imperfection, 0 means that it is absent. The YAML files in config/robots/ hold the same names with
// the same units (loader: config/load/simulation_config.hpp).
//
// Frames: the room has its own frame in metres; the robot's body frame has x forward, y left, its origin in
// the middle of the axle. Angles are in radians, counter-clockwise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wheelwright::simulation {

// One drive motor with its gear, seen from the wheel (that is, with the gear ratio already applied).
struct MotorConfig {
  double resistance_ohm = 8.0;        // winding and bridge
  double back_emf_v_s_per_rad = 0.8;  // volts per rad/s of the wheel; also its torque in Nm per ampere
  double inertia_kg_m2 = 0.004;       // rotor and gear, seen from the wheel
  bool bridge_can_brake = true;       // false: current flows only with the duty, the motor coasts at duty 0
  double warm_up_time_s = 600.0;      // time constant of warming while turning
  double resistance_change_when_warm = 0;  // fraction by which the winding resistance has risen when warm
  double friction_change_when_warm = 0;  // fraction by which friction has risen (negative: fallen) when warm
};

// Friction of one wheel's bearing and gear (bristle model of Canudas de Wit et al. with a Stribeck curve).
struct FrictionConfig {
  double coulomb_nm = 0.0;
  double stiction_nm = 0.0;  // at rest, at least coulomb_nm
  double viscous_nm_s_per_rad = 0.004;
  double stribeck_speed_rad_s = 0.5;      // speed at which stiction has given way to Coulomb friction
  double bristle_deflection_rad = 0.001;  // how far the wheel gives before it breaks away
};

// What one side has of its own.
struct WheelConfig {
  double diameter_m = 0.072;
  double inertia_kg_m2 = 0.0003;
  double eccentricity = 0.0;            // rolling radius varies by this fraction once per turn
  double eccentricity_phase_rad = 0.0;  // wheel angle of the largest radius, at the start
  double backlash_rad = 0.0;            // gear play, at the wheel
  double motor_strength = 1.0;          // this side's torque constant against MotorConfig
  MotorConfig motor;
  FrictionConfig friction;
};

struct CasterConfig {
  double position_m = 0.13;       // ahead of the axle
  double trail_m = 0.012;         // contact point behind the swivel
  double rolling_drag_n = 0.0;    // along the caster's own heading
  double swivel_torque_nm = 0.0;  // turning it over after a reversal: the caster's kick
};

struct ChassisConfig {
  double mass_kg = 3.6;
  double yaw_inertia_kg_m2 = 0.05;  // about the middle of the axle
  double wheel_base_m = 0.235;
  double bumper_radius_m = 0.174;
  double load_on_drive_wheels = 0.8;  // share of the weight; the caster carries the rest
  double yaw_scrub_nm = 0.0;          // drag of the tyres' width against turning
  CasterConfig caster;
};

// A kind of floor. Grip 0 is a floor on which wheels never slip.
struct Surface {
  double grip = 0.0;          // largest traction force / load
  double creep_per_n = 0.0;   // slip of a rolling wheel per newton of traction, as a fraction of its speed
  double rolling_drag = 0.0;  // drag force / weight (carpet pile)
  double scrub_factor = 1.0;  // multiplies ChassisConfig::yaw_scrub_nm
  double slope_x = 0.0;       // rise per metre along the room's x
  double slope_y = 0.0;
};

struct Region {
  enum class Shape { rectangle, circle };
  Shape shape = Shape::rectangle;
  double x_m = 0.0;  // centre
  double y_m = 0.0;
  double size_x_m = 0.0;  // rectangle: full width; circle: diameter
  double size_y_m = 0.0;
  double angle_rad = 0.0;
};

struct SurfacePatch {
  Region region;
  Surface surface;
};

struct WallSegment {
  double x1_m, y1_m, x2_m, y2_m;
};

struct RoomConfig {
  Surface floor;
  std::vector<SurfacePatch> patches;  // the last one that holds a point counts
  std::vector<WallSegment> walls;
  std::vector<Region> obstacles;
  std::vector<Region> cliffs;     // floor that is not there
  double wall_reflectance = 1.0;  // of infrared, for the light bumper
};

// The wheel-speed controller and the counters of the robot's firmware.
struct FirmwareConfig {
  double tick_s = 0.015625;  // of the wheel-speed controller
  double sensor_update_period_s = 0.015625;
  int command_delay_ticks = 0;           // a drive command acts this many ticks later
  bool whole_counts = false;             // the controller sees whole counts; false: the exact angle
  bool staircase = false;                // commands act in whole counts per tick, rounded up from 10 mm/s on
  double nominal_voltage_v = 14.4;       // that feed-forward assumes
  bool voltage_compensation = false;     // feed-forward uses the measured voltage instead
  double feed_forward_v_s_per_m = 23.0;  // volts per m/s of command
  double feed_forward_offset_v = 0.0;    // volts added in the direction of motion, against friction
  double proportional_v_s_per_m = 20.0;
  double integral_v_per_m = 200.0;
  double derivative_v_s2_per_m = 0.0;
  double speed_limit_m_s = 0.5;
};

// How the sign of encoder counts comes about; the sensor itself is not a quadrature encoder.
enum class EncoderSign {
  true_direction,  // as if it were
  command,         // Create 2 Open Interface pages 30-31: sign of the command, and up where it is 0
  motor_drive,     // sign of the voltage at the motor
};

struct EncoderConfig {
  double counts_per_revolution = 508.8;
  EncoderSign sign = EncoderSign::true_direction;
  int start_count_left = 0;
  int start_count_right = 0;
  bool swap_sides = false;  // packet 43 is the right wheel, as page 26 of the Roomba 500 document has it
};

struct BatteryConfig {
  double full_voltage_v = 16.2;   // open circuit
  double empty_voltage_v = 16.2;  // the same as full: no sag with discharge
  double internal_resistance_ohm = 0.0;
  double capacity_mah = 3000.0;
  double charge = 0.8;  // fraction at the start
  double idle_current_a = 0.0;
  double voltage_noise_v = 0.0;  // standard deviation of packet 22
  double temperature_c = 25.0;
};

struct LightBumperConfig {
  double range_m = 0.3;  // beyond it the signal is 0
  double mount_radius_m = 0.165;
  double signal_at_contact = 3800;   // right in front of a white wall
  double falloff_m = 0.05;           // distance at which the signal has fallen to a quarter
  double beam_half_angle_rad = 0.0;  // 0: a thin ray
  double noise = 0.0;                // standard deviation in signal units
  double threshold = 120.0;          // signal from which packet 45 sets its bit
};

struct ByteFaults {
  double loss_probability = 0.0;
  double bit_flip_probability = 0.0;  // per byte
};

// The Open Interface as this robot speaks it, and the cable to it.
struct LinkConfig {
  int baud = 115200;
  bool checksum_excludes_header = false;  // the rule of the Roomba 500 document
  bool mode_plus_one = false;             // packet 35 of some 600-series firmware
  double sleep_after_s = 300.0;           // in Passive without a command; 0: never
  double boot_time_s = 1.0;               // from power-on or opcode 7 to listening
  std::string boot_text = "bl-start\r\nsimulated robot\r\nboot loader 1\r\nbattery-current-zero 0\r\n";
  std::string stray_text;  // written into the line now and then
  double stray_text_interval_s = 0.0;
  ByteFaults to_robot;
  ByteFaults to_host;
  double latency_to_robot_s = 0.0;
  double usb_latency_timer_s = 0.0;  // FTDI: bytes wait for this timer ...
  int usb_chunk_bytes = 62;          // ... or for this many
  bool charger_connected = false;
};

struct StartConfig {
  double x_m = 0.0;
  double y_m = 0.0;
  double theta_rad = 0.0;
  double position_spread_m = 0.0;  // standard deviation, drawn once from the seed
  double heading_spread_rad = 0.0;
};

struct SimulationConfig {
  std::string name = "perfect";
  std::uint64_t seed = 1;
  double physics_step_s = 0.001;
  WheelConfig left;
  WheelConfig right;
  ChassisConfig chassis;
  FirmwareConfig firmware;
  EncoderConfig encoder;
  BatteryConfig battery;
  LightBumperConfig light_bumper;
  LinkConfig link;
  StartConfig start;
  RoomConfig room;
};

}  // namespace wheelwright::simulation

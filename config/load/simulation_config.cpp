#include "config/load/simulation_config.hpp"

#include <algorithm>
#include <array>

#include "config/load/yaml_reader.hpp"

namespace wheelwright::config {
namespace {

using namespace simulation;

constexpr int deepest_base = 8;
constexpr Range any_count{-32768, 65535, "counts"};
constexpr Range fraction{0.0, 1.0};

// Replaces a value by what the file says, if it says something.
void read(YamlReader& from, std::string_view key, double& value, Range range) {
  value = from.number(key, range, value);
}

void read(YamlReader& from, std::string_view key, int& value, Range range) {
  value = static_cast<int>(from.integer(key, range, std::int64_t{value}));
}

void read(YamlReader& from, std::string_view key, bool& value) {
  value = from.boolean(key, value);
}

// A section that may be missing, read to its end.
template <typename Target, typename Read>
void read_section(YamlReader& from, std::string_view key, Target& target, Read read_into) {
  if (auto section = from.section(key)) {
    read_into(*section, target);
    section->finish();
  }
}

void read_motor(YamlReader& from, MotorConfig& motor) {
  read(from, "resistance_ohm", motor.resistance_ohm, {0.1, 100, "ohm"});
  read(from, "back_emf_v_s_per_rad", motor.back_emf_v_s_per_rad, {0.01, 10, "V s/rad"});
  read(from, "inertia_kg_m2", motor.inertia_kg_m2, {1e-5, 0.1, "kg m2"});
  read(from, "bridge_can_brake", motor.bridge_can_brake);
  read(from, "warm_up_time_s", motor.warm_up_time_s, {1, 1e5, "s"});
  read(from, "resistance_change_when_warm", motor.resistance_change_when_warm, {-0.9, 2});
  read(from, "friction_change_when_warm", motor.friction_change_when_warm, {-0.9, 2});
}

void read_friction(YamlReader& from, FrictionConfig& friction) {
  read(from, "coulomb_nm", friction.coulomb_nm, {0, 2, "Nm"});
  read(from, "stiction_nm", friction.stiction_nm, {0, 2, "Nm"});
  read(from, "viscous_nm_s_per_rad", friction.viscous_nm_s_per_rad, {0, 1, "Nm s/rad"});
  read(from, "stribeck_speed_rad_s", friction.stribeck_speed_rad_s, {0.01, 100, "rad/s"});
  read(from, "bristle_deflection_rad", friction.bristle_deflection_rad, {1e-4, 0.1, "rad"});
}

void read_wheel(YamlReader& from, WheelConfig& wheel) {
  read(from, "diameter_m", wheel.diameter_m, {0.02, 0.5, "m"});
  read(from, "inertia_kg_m2", wheel.inertia_kg_m2, {1e-5, 0.1, "kg m2"});
  read(from, "eccentricity", wheel.eccentricity, {0, 0.2});
  read(from, "eccentricity_phase_rad", wheel.eccentricity_phase_rad, {-7, 7, "rad"});
  read(from, "backlash_rad", wheel.backlash_rad, {0, 0.5, "rad"});
  read(from, "motor_strength", wheel.motor_strength, {0.1, 2});
  read_section(from, "motor", wheel.motor, read_motor);
  read_section(from, "friction", wheel.friction, read_friction);
}

// `wheels` holds what both sides share; `left` and `right` what is a side's own.
void read_wheels(YamlReader& from, SimulationConfig& robot) {
  for (WheelConfig* wheel : {&robot.left, &robot.right}) read_section(from, "wheels", *wheel, read_wheel);
  read_section(from, "left", robot.left, read_wheel);
  read_section(from, "right", robot.right, read_wheel);
}

void read_caster(YamlReader& from, CasterConfig& caster) {
  read(from, "position_m", caster.position_m, {-0.5, 0.5, "m"});
  read(from, "trail_m", caster.trail_m, {0.005, 0.1, "m"});
  read(from, "rolling_drag_n", caster.rolling_drag_n, {0, 20, "N"});
  read(from, "swivel_torque_nm", caster.swivel_torque_nm, {0, 1, "Nm"});
}

void read_chassis(YamlReader& from, ChassisConfig& chassis) {
  read(from, "mass_kg", chassis.mass_kg, {0.5, 50, "kg"});
  read(from, "yaw_inertia_kg_m2", chassis.yaw_inertia_kg_m2, {0.001, 5, "kg m2"});
  read(from, "wheel_base_m", chassis.wheel_base_m, {0.05, 1, "m"});
  read(from, "bumper_radius_m", chassis.bumper_radius_m, {0.05, 1, "m"});
  read(from, "load_on_drive_wheels", chassis.load_on_drive_wheels, fraction);
  read(from, "yaw_scrub_nm", chassis.yaw_scrub_nm, {0, 5, "Nm"});
  read_section(from, "caster", chassis.caster, read_caster);
}

void read_firmware(YamlReader& from, FirmwareConfig& firmware) {
  read(from, "tick_s", firmware.tick_s, {0.0005, 0.1, "s"});
  read(from, "sensor_update_period_s", firmware.sensor_update_period_s, {0.0005, 1, "s"});
  read(from, "command_delay_ticks", firmware.command_delay_ticks, {0, 40, "ticks"});
  read(from, "whole_counts", firmware.whole_counts);
  read(from, "staircase", firmware.staircase);
  read(from, "nominal_voltage_v", firmware.nominal_voltage_v, {1, 60, "V"});
  read(from, "voltage_compensation", firmware.voltage_compensation);
  read(from, "feed_forward_v_s_per_m", firmware.feed_forward_v_s_per_m, {0, 500, "V s/m"});
  read(from, "feed_forward_offset_v", firmware.feed_forward_offset_v, {0, 10, "V"});
  read(from, "proportional_v_s_per_m", firmware.proportional_v_s_per_m, {0, 500, "V s/m"});
  read(from, "integral_v_per_m", firmware.integral_v_per_m, {0, 1e4, "V/m"});
  read(from, "derivative_v_s2_per_m", firmware.derivative_v_s2_per_m, {0, 50, "V s2/m"});
  read(from, "speed_limit_m_s", firmware.speed_limit_m_s, {0.01, 5, "m/s"});
}

void read_encoder(YamlReader& from, EncoderConfig& encoder) {
  read(from, "counts_per_revolution", encoder.counts_per_revolution, {1, 1e5, "counts"});
  encoder.sign = from.choice<EncoderSign>("sign",
                                          {{"true_direction", EncoderSign::true_direction},
                                           {"command", EncoderSign::command},
                                           {"motor_drive", EncoderSign::motor_drive}},
                                          encoder.sign);
  read(from, "start_count_left", encoder.start_count_left, any_count);
  read(from, "start_count_right", encoder.start_count_right, any_count);
  read(from, "swap_sides", encoder.swap_sides);
}

void read_battery(YamlReader& from, BatteryConfig& battery) {
  read(from, "full_voltage_v", battery.full_voltage_v, {1, 60, "V"});
  read(from, "empty_voltage_v", battery.empty_voltage_v, {1, 60, "V"});
  read(from, "internal_resistance_ohm", battery.internal_resistance_ohm, {0, 10, "ohm"});
  read(from, "capacity_mah", battery.capacity_mah, {1, 65535, "mAh"});
  read(from, "charge", battery.charge, fraction);
  read(from, "idle_current_a", battery.idle_current_a, {0, 10, "A"});
  read(from, "voltage_noise_v", battery.voltage_noise_v, {0, 1, "V"});
  read(from, "temperature_c", battery.temperature_c, {-40, 90, "degC"});
}

void read_light_bumper(YamlReader& from, LightBumperConfig& light) {
  read(from, "range_m", light.range_m, {0.01, 5, "m"});
  read(from, "mount_radius_m", light.mount_radius_m, {0.01, 1, "m"});
  read(from, "signal_at_contact", light.signal_at_contact, {0, 4095});
  read(from, "falloff_m", light.falloff_m, {0.001, 5, "m"});
  read(from, "beam_half_angle_rad", light.beam_half_angle_rad, {0, 1, "rad"});
  read(from, "noise", light.noise, {0, 1000});
  read(from, "threshold", light.threshold, {1, 4095});
}

void read_byte_faults(YamlReader& from, ByteFaults& faults) {
  read(from, "loss_probability", faults.loss_probability, fraction);
  read(from, "bit_flip_probability", faults.bit_flip_probability, fraction);
}

void read_link(YamlReader& from, LinkConfig& link) {
  constexpr std::array bauds{300, 600, 1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 115200};
  read(from, "baud", link.baud, {300, 115200, "baud"});
  if (std::find(bauds.begin(), bauds.end(), link.baud) == bauds.end()) {
    from.fail("baud", "is no speed of the Open Interface; the usual ones are 115200 and 19200");
  }
  read(from, "checksum_excludes_header", link.checksum_excludes_header);
  read(from, "mode_plus_one", link.mode_plus_one);
  read(from, "sleep_after_s", link.sleep_after_s, {0, 1e6, "s"});
  read(from, "boot_time_s", link.boot_time_s, {0, 60, "s"});
  link.boot_text = from.text("boot_text", link.boot_text);
  link.stray_text = from.text("stray_text", link.stray_text);
  read(from, "stray_text_interval_s", link.stray_text_interval_s, {0, 1e6, "s"});
  read_section(from, "to_robot", link.to_robot, read_byte_faults);
  read_section(from, "to_host", link.to_host, read_byte_faults);
  read(from, "latency_to_robot_s", link.latency_to_robot_s, {0, 1, "s"});
  read(from, "usb_latency_timer_s", link.usb_latency_timer_s, {0, 0.255, "s"});
  read(from, "usb_chunk_bytes", link.usb_chunk_bytes, {1, 4096, "bytes"});
  read(from, "charger_connected", link.charger_connected);
}

void read_start(YamlReader& from, StartConfig& start) {
  read(from, "x_m", start.x_m, {-1000, 1000, "m"});
  read(from, "y_m", start.y_m, {-1000, 1000, "m"});
  read(from, "theta_rad", start.theta_rad, {-7, 7, "rad"});
  read(from, "position_spread_m", start.position_spread_m, {0, 10, "m"});
  read(from, "heading_spread_rad", start.heading_spread_rad, {0, 7, "rad"});
}

SimulationConfig load_above(const std::filesystem::path& path, int depth) {
  YamlReader file = YamlReader::load(path);
  SimulationConfig robot;
  if (file.has("based_on")) {
    if (depth == deepest_base) file.fail("based_on", "leads in a circle, or more than 8 files deep");
    robot = load_above(file.existing_file("based_on"), depth + 1);
  }
  robot.name = file.text("name", path.stem().string());
  robot.seed = static_cast<std::uint64_t>(
      file.integer("seed", {0, 9007199254740992.0}, static_cast<std::int64_t>(robot.seed)));
  read(file, "physics_step_s", robot.physics_step_s, {1e-5, 0.001, "s"});
  read_wheels(file, robot);
  read_section(file, "chassis", robot.chassis, read_chassis);
  read_section(file, "firmware", robot.firmware, read_firmware);
  read_section(file, "encoder", robot.encoder, read_encoder);
  read_section(file, "battery", robot.battery, read_battery);
  read_section(file, "light_bumper", robot.light_bumper, read_light_bumper);
  read_section(file, "link", robot.link, read_link);
  read_section(file, "start", robot.start, read_start);
  if (file.has("room")) robot.room = load_room(file.existing_file("room"));
  file.finish();
  return robot;
}

}  // namespace

simulation::SimulationConfig load_simulation_config(const std::filesystem::path& path) {
  return load_above(path, 0);
}

}  // namespace wheelwright::config

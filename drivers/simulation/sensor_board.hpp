// The robot's sensor values as the Open Interface hands them out: refreshed once per sensor period, and in
// between always the same.
#pragma once

#include <array>
#include <cstdint>

#include "drivers/open_interface/packets.hpp"
#include "drivers/simulation/light_bumper.hpp"
#include "drivers/simulation/mechanics.hpp"
#include "drivers/simulation/noise.hpp"
#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class SensorBoard {
 public:
  explicit SensorBoard(const SimulationConfig& config);

  // Reads all sensors. What the firmware itself knows (mode, songs, requests) is not touched.
  void refresh(const Mechanics& mechanics, bool charger_connected, Noise& noise);

  std::int32_t value(open_interface::PacketId id) const { return values_[index(id)]; }
  void set(open_interface::PacketId id, std::int32_t value) { values_[index(id)] = value; }
  // Distance and angle start again from zero each time they have been asked for.
  void asked_for(open_interface::PacketId id);

  bool any_cliff() const;
  bool any_wheel_drop() const;

 private:
  static std::size_t index(open_interface::PacketId id) { return static_cast<std::size_t>(id) - 7U; }
  void refresh_contacts(const Mechanics& mechanics);
  void refresh_odometry(const Mechanics& mechanics);
  void refresh_power(const Mechanics& mechanics, bool charger_connected, Noise& noise);
  void refresh_light_bumper(const Mechanics& mechanics, Noise& noise);

  EncoderConfig encoder_;
  BatteryConfig battery_;
  LightBumper light_bumper_;
  std::array<std::int32_t, 52> values_{};
  std::int64_t last_left_ = 0;
  std::int64_t last_right_ = 0;
  double distance_mm_ = 0.0;
  double angle_deg_ = 0.0;
};

}  // namespace wheelwright::simulation

// The robot's end of the Open Interface: modes, commands, queries, the stream (shared/OI sections 1.2 to 1.5;
// iRobot "Roomba 500 Open Interface Specification" and "Create 2 Open Interface").
//
// It answers to what the documents leave open like this: in Off mode only Start (128) and Reset (7) are
// understood; Power (133) puts the robot to sleep like five minutes in Passive do; cleaning commands (134 to
// 136, 143) drop to Passive and move nothing; packets 35 to 42 answer at once, all others as last refreshed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "drivers/simulation/command_parser.hpp"
#include "drivers/simulation/mechanics.hpp"
#include "drivers/simulation/noise.hpp"
#include "drivers/simulation/sensor_board.hpp"
#include "drivers/simulation/serial_line.hpp"
#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

enum class OiMode : std::uint8_t { off = 0, passive = 1, safe = 2, full = 3 };

class OpenInterfaceServer {
 public:
  // All references must outlive the server.
  OpenInterfaceServer(const SimulationConfig& config, Mechanics& mechanics, SensorBoard& sensors,
                      SerialLine& from_host, SerialLine& to_host, Noise& noise);

  // Whether this byte completed a drive command (137, 145, 146) that the mode allows and that is not to
  // stand.
  bool receive(std::uint8_t byte, Nanoseconds now);
  // Once per sensor period, after the sensors were refreshed: safety, sleep, stray text, and the stream's
  // next frame.
  void sensor_tick(Nanoseconds now);

  void power_off();
  void power_on(Nanoseconds now);
  void wake(Nanoseconds now);
  void plug_charger(bool connected) { charger_connected_ = connected; }

  bool charger_connected() const { return charger_connected_; }
  OiMode mode() const { return mode_; }
  bool asleep() const { return power_ == Power::asleep; }
  int boots() const { return boots_; }

 private:
  enum class Power { off, booting, asleep, awake };

  void obey(const HostCommand& command);
  bool may_drive() const { return mode_ == OiMode::safe || mode_ == OiMode::full; }
  void apply_drive_command(const HostCommand& command);
  void drive(std::int32_t velocity_mm_s, std::int32_t radius_mm);
  void enter(OiMode mode);
  void boot(Nanoseconds now);
  void change_baud(std::uint8_t code);
  void set_stream(std::span<const std::uint8_t> ids);
  void press_buttons(std::uint8_t bits);
  void play(std::uint8_t song);
  void guard_safe_mode();
  void send_stream_frame();
  void send_packets(std::uint8_t id);
  std::size_t append_packets(std::uint8_t id, std::span<std::uint8_t> out);
  void send(std::uint8_t byte) { to_host_.send(byte, now_, noise_); }
  void send(std::string_view text);
  void publish_mode();

  LinkConfig link_;
  Mechanics& mechanics_;
  SensorBoard& sensors_;
  SerialLine& from_host_;
  SerialLine& to_host_;
  Noise& noise_;
  CommandParser parser_;
  Nanoseconds now_{0};
  Power power_ = Power::awake;
  OiMode mode_ = OiMode::off;
  bool charger_connected_;
  Nanoseconds last_command_{0};
  Nanoseconds boots_until_{0};
  int boots_ = 0;
  Nanoseconds next_stray_text_{0};
  Nanoseconds buttons_until_{0};
  Nanoseconds song_until_{0};
  std::array<Nanoseconds, 5> song_length_{};
  std::array<std::uint8_t, 255> stream_ids_{};
  std::size_t stream_length_ = 0;
  bool streaming_ = false;
};

}  // namespace wheelwright::simulation

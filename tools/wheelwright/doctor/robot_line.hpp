// The serial line to a robot, for as long as the doctor looks at it.
//
// Once a robot is known to listen, it is left at rest, in Passive mode and silent, whatever happens.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "drivers/open_interface/line_bits.hpp"
#include "drivers/serial/serial_port.hpp"

namespace wheelwright::tools::doctor {

using Clock = std::chrono::steady_clock;

inline constexpr std::size_t padding_bytes = 40;  // longer than any command that may be half sent

class RobotLine {
 public:
  // Throws UsageError where the port cannot be opened.
  RobotLine(std::filesystem::path device, int baud);
  RobotLine(const RobotLine&) = delete;
  RobotLine& operator=(const RobotLine&) = delete;
  ~RobotLine();

  // Closes the port and opens it again at another speed.
  void change_baud(int baud);

  // Sends all bytes. Throws DataRefusal where the line has gone dead.
  void send(std::span<const std::uint8_t> bytes);

  // Waits for bytes, no longer than until `deadline`; empty where none came. Valid until the next call.
  // Throws DataRefusal where the line has gone dead, and Interrupted.
  std::span<const std::uint8_t> receive(Clock::time_point deadline);

  // A robot listens at this speed.
  void note_robot() { robot_listens_ = true; }

  // Of all bytes that came at this speed.
  const open_interface::LineBits& bits() const { return bits_; }

  // Wheels to rest, Passive mode, no stream; returns when the bytes have left. Never throws.
  void leave_at_rest() noexcept;

  const serial::OpenPort& port() const { return port_; }
  const std::filesystem::path& device() const { return device_; }
  int baud() const { return baud_; }

 private:
  void open();
  bool send_all(std::span<const std::uint8_t> bytes) noexcept;

  std::filesystem::path device_;
  int baud_;
  bool robot_listens_ = false;
  serial::OpenPort port_;
  open_interface::LineBits bits_;
  std::array<std::uint8_t, 1024> input_{};
};

// A name for the driver behind a port, as the system has it: "ftdi_sio", "pseudo-terminal", or empty.
std::string driver_of(const std::filesystem::path& device);

// A UART of the machine itself, not of a USB adapter.
bool is_on_board(const std::filesystem::path& device);

}  // namespace wheelwright::tools::doctor

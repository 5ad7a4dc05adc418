// The cable between robot and daemon, cut open: everything that passes can be watched, delayed, lost or
// forged.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "drivers/simulation/pseudo_terminal.hpp"

namespace wheelwright::bench {

class LineTap {
 public:
  using Clock = std::chrono::steady_clock;

  // `robot` is the terminal of the simulated robot; the daemon is to open `device`, a link made here.
  LineTap(const std::filesystem::path& robot, std::filesystem::path device);
  LineTap(const LineTap&) = delete;
  LineTap& operator=(const LineTap&) = delete;
  ~LineTap();

  // What the robot sends from now on arrives so much later; what follows stays behind it.
  void delay_replies(std::chrono::milliseconds by) { delay_ms_ = static_cast<int>(by.count()); }
  // Loses all that the robot sends, until told otherwise.
  void lose_replies(bool lose) { lose_replies_ = lose; }
  // Flips the top bit of every so manieth byte of the robot's; 0: of none.
  void garble_every(int bytes) { garble_every_ = bytes; }
  // Pulls the adapter out: the daemon's port is gone, and with it its name. Put in again it is a new one.
  void pull_out();
  void put_in();
  // Slips a command in between those of the daemon.
  void tell_robot(std::span<const std::uint8_t> bytes);

  // When the daemon last ordered anything but standing, and first ordered standing after that.
  struct DriveOrders {
    std::optional<Clock::time_point> last_moving;
    std::optional<Clock::time_point> first_standing;
  };
  DriveOrders drive_orders() const;
  // Bytes that the daemon has sent so far.
  std::size_t sent_by_daemon() const { return sent_by_daemon_; }

 private:
  struct Late {
    Clock::time_point due;
    std::vector<std::uint8_t> bytes;
  };

  void run();
  void carry_orders();
  void carry_replies();
  void garble(std::span<std::uint8_t> bytes);
  void note_orders(std::span<const std::uint8_t> bytes);

  std::filesystem::path device_;
  int robot_ = -1;
  mutable std::mutex mutex_;  // of all that follows up to the atomics
  std::unique_ptr<simulation::PseudoTerminal> terminal_;
  std::unique_ptr<simulation::TerminalLink> link_;
  std::deque<Late> replies_;
  DriveOrders orders_;
  int ungarbled_bytes_ = 0;
  std::atomic<int> delay_ms_{0};
  std::atomic<bool> lose_replies_{false};
  std::atomic<int> garble_every_{0};
  std::atomic<std::size_t> sent_by_daemon_{0};
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace wheelwright::bench

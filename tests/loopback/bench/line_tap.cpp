#include "tests/loopback/bench/line_tap.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "drivers/serial/serial_port.hpp"
#include "tests/loopback/bench/child_process.hpp"

namespace wheelwright::bench {
namespace {

constexpr std::uint8_t drive_direct = 145;
constexpr std::uint8_t drive_pwm = 146;
constexpr std::size_t drive_data_bytes = 4;

}  // namespace

LineTap::LineTap(const std::filesystem::path& robot, std::filesystem::path device)
    : device_(std::move(device)) {
  const auto port = serial::open_port(robot, 115200);
  if (!port) throw std::runtime_error(port.error().message);
  robot_ = port->descriptor;
  put_in();
  thread_ = std::thread([this] { run(); });
}

LineTap::~LineTap() {
  ending_ = true;
  thread_.join();
  ::close(robot_);
}

void LineTap::pull_out() {
  const std::lock_guard lock(mutex_);
  link_.reset();
  terminal_.reset();
  replies_.clear();
}

void LineTap::put_in() {
  const std::lock_guard lock(mutex_);
  terminal_ = std::make_unique<simulation::PseudoTerminal>();
  link_ = std::make_unique<simulation::TerminalLink>(device_, terminal_->path());
}

void LineTap::tell_robot(std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(mutex_);
  if (::write(robot_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the simulated robot takes no bytes");
  }
}

LineTap::DriveOrders LineTap::drive_orders() const {
  const std::lock_guard lock(mutex_);
  return orders_;
}

void LineTap::run() {
  schedule_calling_thread(Scheduling::like_hardware);
  while (!ending_) {
    {
      const std::lock_guard lock(mutex_);
      carry_orders();
      carry_replies();
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
}

void LineTap::carry_orders() {
  std::array<std::uint8_t, 1024> buffer{};
  if (!terminal_) return;
  while (const std::size_t count = terminal_->read(buffer)) {
    const auto bytes = std::span(buffer).first(count);
    sent_by_daemon_ += count;
    note_orders(bytes);
    if (::write(robot_, bytes.data(), bytes.size()) < 0) return;
  }
}

void LineTap::carry_replies() {
  std::array<std::uint8_t, 1024> buffer{};
  const auto now = Clock::now();
  for (ssize_t count = 0; (count = ::read(robot_, buffer.data(), buffer.size())) > 0;) {
    garble(std::span(buffer).first(static_cast<std::size_t>(count)));
    if (!lose_replies_ && terminal_) {
      const auto due = now + std::chrono::milliseconds(delay_ms_);
      replies_.push_back({replies_.empty() ? due : std::max(due, replies_.back().due),
                          {buffer.begin(), buffer.begin() + count}});
    }
  }
  while (!replies_.empty() && replies_.front().due <= now) {
    if (terminal_) terminal_->write(replies_.front().bytes);
    replies_.pop_front();
  }
}

void LineTap::garble(std::span<std::uint8_t> bytes) {
  const int every = garble_every_;
  for (std::uint8_t& byte : bytes) {
    if (every == 0 || ++ungarbled_bytes_ < every) continue;
    byte ^= 0x80U;
    ungarbled_bytes_ = 0;
  }
}

// The daemon writes whole commands, and none of those that it sends with a drive command has data bytes that
// look like one.
void LineTap::note_orders(std::span<const std::uint8_t> bytes) {
  for (std::size_t at = 0; at + drive_data_bytes < bytes.size(); ++at) {
    if (bytes[at] != drive_direct && bytes[at] != drive_pwm) continue;
    const auto data = bytes.subspan(at + 1, drive_data_bytes);
    const bool stands = std::all_of(data.begin(), data.end(), [](std::uint8_t byte) { return byte == 0; });
    if (!stands) {
      orders_ = {Clock::now(), std::nullopt};
    } else if (!orders_.first_standing) {
      orders_.first_standing = Clock::now();
    }
    at += drive_data_bytes;
  }
}

}  // namespace wheelwright::bench

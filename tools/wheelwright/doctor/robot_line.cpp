#include "tools/wheelwright/doctor/robot_line.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "drivers/open_interface/commands.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/doctor/interruption.hpp"

namespace wheelwright::tools::doctor {
namespace {

using namespace std::chrono_literals;

constexpr auto longest_wait = 50ms;  // between looks at a pending interruption
constexpr auto patience_of_writes = 200ms;

// Waits until the port has room or data; no longer than `patience`.
short wait_for(int descriptor, short events, Clock::duration patience) noexcept {
  pollfd wanted{descriptor, events, 0};
  const auto wait = std::chrono::ceil<std::chrono::milliseconds>(std::max(patience, Clock::duration::zero()));
  return ::poll(&wanted, 1, static_cast<int>(wait.count())) > 0 ? wanted.revents : short{0};
}

}  // namespace

RobotLine::RobotLine(std::filesystem::path device, int baud) : device_(std::move(device)), baud_(baud) {
  open();
}

RobotLine::~RobotLine() {
  leave_at_rest();
  ::close(port_.descriptor);
}

void RobotLine::open() {
  auto port = serial::open_port(device_, baud_);
  if (!port) throw UsageError(serial::detailed_message(port.error(), device_));
  port_ = *port;
}

void RobotLine::change_baud(int baud) {
  ::close(port_.descriptor);
  port_.descriptor = -1;
  baud_ = baud;
  bits_ = {};
  open();
}

bool RobotLine::send_all(std::span<const std::uint8_t> bytes) noexcept {
  const auto deadline = Clock::now() + patience_of_writes;
  while (!bytes.empty() && Clock::now() < deadline) {
    const ssize_t written = ::write(port_.descriptor, bytes.data(), bytes.size());
    if (written > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      wait_for(port_.descriptor, POLLOUT, deadline - Clock::now());
    } else if (errno != EINTR) {
      return false;
    }
  }
  return bytes.empty();
}

void RobotLine::send(std::span<const std::uint8_t> bytes) {
  if (!send_all(bytes)) throw DataRefusal(device_.string() + ": the line went dead; is the cable still in?");
}

std::span<const std::uint8_t> RobotLine::receive(Clock::time_point deadline) {
  while (true) {
    throw_if_interrupted();
    const auto left = std::min<Clock::duration>(deadline - Clock::now(), longest_wait);
    wait_for(port_.descriptor, POLLIN, left);
    const ssize_t count = ::read(port_.descriptor, input_.data(), input_.size());
    if (count > 0) {
      const auto bytes = std::span(input_).first(static_cast<std::size_t>(count));
      for (const std::uint8_t byte : bytes) bits_.take(byte);
      return bytes;
    }
    const bool merely_empty = count < 0 && (errno == EAGAIN || errno == EINTR);
    if (!merely_empty) throw DataRefusal(device_.string() + ": the line went dead; is the cable still in?");
    if (Clock::now() >= deadline) return {};
  }
}

// Zeros first, for a command that lost a byte on the way and still waits for its end.
void RobotLine::leave_at_rest() noexcept {
  if (!robot_listens_ || port_.descriptor < 0) return;
  open_interface::CommandBytes bytes;
  bytes.padding(padding_bytes);
  bytes.pause_stream();
  bytes.drive_direct(0, 0);
  bytes.start();
  if (!send_all(bytes.bytes())) return;
  // Closing may throw away what has not left yet.
  int waiting = 0;
  for (int i = 0; i < 20; ++i) {
    if (::ioctl(port_.descriptor, TIOCOUTQ, &waiting) != 0 || waiting == 0) break;
    ::usleep(5000);
  }
}

bool is_on_board(const std::filesystem::path& device) {
  std::error_code error;
  const std::string real = std::filesystem::canonical(device, error).filename().string();
  return real.starts_with("ttyS") || real.starts_with("ttyAMA");
}

std::string driver_of(const std::filesystem::path& device) {
  std::error_code error;
  const auto real = std::filesystem::canonical(device, error);
  if (error) return "";
  if (real.string().starts_with("/dev/pts/")) return "pseudo-terminal";
  const auto driver =
      std::filesystem::canonical("/sys/class/tty/" + real.filename().string() + "/device/driver", error);
  return error ? "" : driver.filename().string();
}

}  // namespace wheelwright::tools::doctor

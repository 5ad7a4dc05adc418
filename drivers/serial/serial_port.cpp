#include "drivers/serial/serial_port.hpp"

#include <fcntl.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "drivers/serial/port_holders.hpp"
#include "drivers/serial/port_list.hpp"

namespace wheelwright::serial {
namespace {

std::optional<speed_t> speed_code(int baud) {
  switch (baud) {
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    case 115200:
      return B115200;
    default:
      return std::nullopt;
  }
}

PortError open_error(const std::filesystem::path& path, int error) {
  const std::string name = path.string();
  if (error == EACCES || error == EPERM) {
    return {PortErrorKind::no_permission,
            name + ": no permission; add the user to the group that owns the device (usually 'dialout')"};
  }
  if (error == EBUSY || error == EWOULDBLOCK) {
    return {PortErrorKind::in_use, name + ": in use by another program; end that one first"};
  }
  if (error == ENOENT || error == ENXIO || error == ENODEV) {
    return {PortErrorKind::missing, name + ": no such device"};
  }
  return {PortErrorKind::not_a_port, name + ": cannot be opened as a serial port: " + std::strerror(error)};
}

bool make_raw(int descriptor, speed_t speed) {
  termios settings{};
  if (::tcgetattr(descriptor, &settings) != 0) return false;
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(HUPCL | CRTSCTS | CSTOPB | PARENB);
  settings.c_cc[VMIN] = 1;  // with 0 a read without data would look like the end of the file
  settings.c_cc[VTIME] = 0;
  ::cfsetispeed(&settings, speed);
  ::cfsetospeed(&settings, speed);
  return ::tcsetattr(descriptor, TCSANOW, &settings) == 0 && ::tcflush(descriptor, TCIOFLUSH) == 0;
}

// An FTDI adapter otherwise holds data back for up to 16 ms, nearly a whole tick.
bool set_low_latency(int descriptor) {
  serial_struct settings{};
  if (::ioctl(descriptor, TIOCGSERIAL, &settings) != 0) return false;
  settings.flags = static_cast<int>(static_cast<unsigned>(settings.flags) | ASYNC_LOW_LATENCY);
  return ::ioctl(descriptor, TIOCSSERIAL, &settings) == 0;
}

std::optional<int> read_latency_timer(const std::filesystem::path& path) {
  std::error_code error;
  const auto device = std::filesystem::canonical(path, error);
  if (error) return std::nullopt;
  std::ifstream timer("/sys/bus/usb-serial/devices/" + device.filename().string() + "/latency_timer");
  int value = 0;
  if (timer >> value) return value;
  return std::nullopt;
}

}  // namespace

tl::expected<OpenPort, PortError> open_port(const std::filesystem::path& path, int baud) {
  const auto speed = speed_code(baud);
  if (!speed) {
    return tl::unexpected(
        PortError{PortErrorKind::not_a_port,
                  path.string() + ": " + std::to_string(baud) + " baud is not known; use 115200 or 19200"});
  }
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return tl::unexpected(open_error(path, errno));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 || !make_raw(descriptor, *speed)) {
    const int error = errno;
    ::close(descriptor);
    return tl::unexpected(open_error(path, error));
  }
  OpenPort port;
  port.descriptor = descriptor;
  port.low_latency = set_low_latency(descriptor);
  port.latency_timer_ms = read_latency_timer(path);
  return port;
}

std::string detailed_message(const PortError& error, const std::filesystem::path& path) {
  switch (error.kind) {
    case PortErrorKind::in_use:
      return path.string() + ": " + in_use_by(path);
    case PortErrorKind::missing:
      return path.string() + ": no such device; " + ports_that_are_there();
    case PortErrorKind::no_permission:
    case PortErrorKind::not_a_port:
      break;
  }
  return error.message;
}

}  // namespace wheelwright::serial

#include "daemon/open_device.hpp"

#include <chrono>
#include <thread>

#include "daemon/exit_status.hpp"

namespace wheelwright::daemon {
namespace {

constexpr auto patience = std::chrono::milliseconds(1500);
constexpr auto try_every = std::chrono::milliseconds(50);

EndCause cause_of(serial::PortErrorKind kind) {
  switch (kind) {
    case serial::PortErrorKind::missing:
      return EndCause::no_device;
    case serial::PortErrorKind::no_permission:
      return EndCause::no_permission;
    case serial::PortErrorKind::in_use:
      return EndCause::device_in_use;
    case serial::PortErrorKind::not_a_port:
      return EndCause::configuration;
  }
  return EndCause::configuration;
}

}  // namespace

serial::OpenPort open_device(const std::filesystem::path& device, int baud) {
  const auto give_up = std::chrono::steady_clock::now() + patience;
  while (true) {
    const auto port = serial::open_port(device, baud);
    if (port) return *port;
    const bool in_use = port.error().kind == serial::PortErrorKind::in_use;
    if (!in_use || std::chrono::steady_clock::now() > give_up) {
      throw StartFailure(cause_of(port.error().kind), port.error().message);
    }
    std::this_thread::sleep_for(try_every);
  }
}

}  // namespace wheelwright::daemon

#include "daemon/guardian/open_device.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <thread>

#include "daemon/service/exit_status.hpp"
#include "drivers/serial/port_holders.hpp"

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

// A terminal program takes no lock, and takes away what the robot answers.
void warn_of_others(const std::filesystem::path& device) {
  const auto others = serial::other_holders(device);
  if (others.empty()) return;
  spdlog::warn("{}: also open in {}, which takes bytes away; end it", device.string(),
               serial::names_of(others));
}

}  // namespace

serial::OpenPort open_device(const std::filesystem::path& device, int baud) {
  const auto give_up = std::chrono::steady_clock::now() + patience;
  while (true) {
    const auto port = serial::open_port(device, baud);
    if (port) {
      warn_of_others(device);
      return *port;
    }
    const bool in_use = port.error().kind == serial::PortErrorKind::in_use;
    if (!in_use || std::chrono::steady_clock::now() > give_up) {
      throw StartFailure(cause_of(port.error().kind), serial::detailed_message(port.error(), device));
    }
    std::this_thread::sleep_for(try_every);
  }
}

}  // namespace wheelwright::daemon

#include "daemon/rest.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <span>
#include <string_view>
#include <thread>

#include "daemon/open_device.hpp"
#include "drivers/roomba/rest_bytes.hpp"

namespace wheelwright::daemon {
namespace {

constexpr int times_told = 3;  // an order that the line garbles is not the last one
constexpr auto told_every = std::chrono::milliseconds(40);

void write_whole(int port, std::span<const std::uint8_t> bytes) {
  for (int i = 0; i < 10 && !bytes.empty(); ++i) {
    const ssize_t written = ::write(port, bytes.data(), bytes.size());
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    if (!bytes.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

bool ended_in_order() {
  const char* how = std::getenv("EXIT_CODE");
  return how != nullptr && std::string_view(how) == "exited";
}

}  // namespace

void rest_wheels(const config::DaemonConfig& config) {
  if (ended_in_order() || !std::filesystem::exists(config.device)) return;
  const serial::OpenPort port = open_device(config.device, config.baud);
  for (int i = 0; i < times_told; ++i) {
    write_whole(port.descriptor, roomba::rest_bytes(config.link.drive_mode).bytes());
    std::this_thread::sleep_for(told_every);
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(roomba::longest_braking_s));
  open_interface::CommandBytes passive;
  passive.start();
  write_whole(port.descriptor, passive.bytes());
  std::this_thread::sleep_for(told_every);  // a pseudo-terminal forgets what is unread when it is closed
  ::close(port.descriptor);
}

}  // namespace wheelwright::daemon

#include "daemon/guardian/rest.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "daemon/guardian/open_device.hpp"
#include "daemon/service/exit_status.hpp"
#include "drivers/roomba/rest_bytes.hpp"

namespace wheelwright::daemon {
namespace {

constexpr int orders = 3;  // an order that the line garbles is not the last one
constexpr auto order_period = std::chrono::milliseconds(40);

void write_whole(int port, std::span<const std::uint8_t> bytes) {
  for (int i = 0; i < 10 && !bytes.empty(); ++i) {
    const ssize_t written = ::write(port, bytes.data(), bytes.size());
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    if (!bytes.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

// After a fault of its own the daemon relied on its guardian, which may be gone too.
bool ended_in_order() {
  const char* how = std::getenv("EXIT_CODE");
  if (how == nullptr || std::string_view(how) != "exited") return false;
  const char* status = std::getenv("EXIT_STATUS");
  return status == nullptr || status != std::to_string(exit_status(EndCause::internal, true));
}

void rest_robot(const config::RestTarget& target) {
  const serial::OpenPort port = open_device(target.device, target.baud);
  for (int i = 0; i < orders; ++i) {
    write_whole(port.descriptor, roomba::rest_bytes(target.drive_mode).bytes());
    std::this_thread::sleep_for(order_period);
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(roomba::longest_braking_s));
  open_interface::CommandBytes passive;
  passive.start();
  write_whole(port.descriptor, passive.bytes());
  std::this_thread::sleep_for(order_period);  // a pseudo-terminal forgets what is unread when it is closed
  ::close(port.descriptor);
}

}  // namespace

std::vector<config::RestTarget> rest_targets(const std::filesystem::path& runtime_folder,
                                             const std::filesystem::path& config_file,
                                             const std::filesystem::path& device) {
  std::vector<config::RestTarget> targets;
  const auto add = [&](config::RestTarget target) {
    if (!device.empty()) target.device = device;
    const bool known = std::any_of(targets.begin(), targets.end(), [&](const config::RestTarget& other) {
      return other.device == target.device && other.baud == target.baud;
    });
    if (!known) targets.push_back(std::move(target));
  };
  if (!runtime_folder.empty()) {
    if (auto kept = config::salvage_rest_target(runtime_folder / rest_target_file_name))
      add(*std::move(kept));
  }
  if (auto configured = config::salvage_rest_target(config_file)) add(*std::move(configured));
  add({});
  return targets;
}

bool rest_wheels(const std::vector<config::RestTarget>& targets) {
  if (ended_in_order()) return true;
  std::optional<StartFailure> failure;
  for (const config::RestTarget& target : targets) {
    std::error_code ignored;
    if (!std::filesystem::exists(target.device, ignored)) continue;
    try {
      rest_robot(target);
      return true;
    } catch (const StartFailure& why) {
      if (!failure) failure = why;
    }
  }
  if (failure) throw StartFailure(*failure);
  return false;
}

}  // namespace wheelwright::daemon

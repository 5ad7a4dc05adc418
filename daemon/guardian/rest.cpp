#include "daemon/guardian/rest.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "daemon/guardian/open_device.hpp"
#include "daemon/service/exit_status.hpp"
#include "drivers/roomba/rest_bytes.hpp"
#include "drivers/roomba/rest_sequence.hpp"

namespace wheelwright::daemon {
namespace {

// After a fault of its own the daemon relied on its guardian, which may be gone too; and to a robot that it
// lost it said no farewell. A device that it could not open it has not touched.
bool ended_in_order(bool has_said_farewell) {
  const char* how = std::getenv("EXIT_CODE");
  if (how == nullptr || std::string_view(how) != "exited") return false;
  const char* status = std::getenv("EXIT_STATUS");
  const auto is = [status](EndCause cause) {
    return status != nullptr && status == std::to_string(exit_status(cause, true));
  };
  if (is(EndCause::device_in_use) || is(EndCause::no_permission)) return true;
  return has_said_farewell && !is(EndCause::internal) && !is(EndCause::robot_silent);
}

void rest_robot(const config::RestTarget& target) {
  const serial::OpenPort port = open_device(target.device, target.baud);
  roomba::rest_and_leave(port.descriptor, roomba::rest_bytes(target.drive_mode));
  ::close(port.descriptor);
}

}  // namespace

void note_farewell(const std::filesystem::path& runtime_folder) {
  std::error_code ignored;
  if (!runtime_folder.empty()) std::filesystem::remove(runtime_folder / rest_target_file_name, ignored);
}

bool lacks_farewell(const std::filesystem::path& runtime_folder) {
  std::error_code ignored;
  return !runtime_folder.empty() && std::filesystem::exists(runtime_folder / rest_target_file_name, ignored);
}

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

bool rest_after_end(const std::filesystem::path& runtime_folder,
                    const std::vector<config::RestTarget>& targets) {
  return ended_in_order(!lacks_farewell(runtime_folder)) || rest_wheels(targets);
}

bool rest_wheels(const std::vector<config::RestTarget>& targets) {
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

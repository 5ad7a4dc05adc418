// How to reach a robot whose wheels have to be put to rest, whatever became of the configuration.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "config/load/daemon_config.hpp"
#include "drivers/roomba/link_config.hpp"

namespace wheelwright::config {

struct RestTarget {
  std::filesystem::path device = "/dev/roomba";
  int baud = 115200;
  roomba::DriveMode drive_mode = roomba::DriveMode::direct;
};

// Of a configuration that was loaded.
RestTarget rest_target(const DaemonConfig& config);

// What a running daemon keeps for the one that puts its robot to rest: a configuration with the section
// `link` alone.
std::string rest_target_to_yaml(const RestTarget& target);

// The section `link` of a file, as far as the file can be read: a mistake elsewhere does not matter, and
// after a line that is no YAML nothing is read. A key that is missing or wrong has its default. Nothing where
// the file cannot be read, or names no device.
std::optional<RestTarget> salvage_rest_target(const std::filesystem::path& file);

}  // namespace wheelwright::config

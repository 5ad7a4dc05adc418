// MCAP files (mcap.dev/spec), record by record from the start: neither index nor summary is needed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tools/wheelwright/import/formats/ros/bag_recording.hpp"
#include "tools/wheelwright/import/formats/ros/storage/file_bytes.hpp"

namespace wheelwright::import::ros {

inline constexpr std::string_view mcap_magic = "\x89MCAP0\r\n";

struct McapScan {
  std::string profile;  // "ros2"
  std::optional<std::string> refusal;
};

// Adds the messages of a file. `label` begins remarks: empty, or the name of a part of a split bag and ": ".
McapScan scan_mcap(FileBytes& file, const std::string& label, BagRecording& recording);

// "ROS 2 bag (MCAP" of the profile "ros2".
std::string mcap_format(std::string_view profile);

}  // namespace wheelwright::import::ros

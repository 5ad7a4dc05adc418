// Bags of ROS 1, version 2.0 (wiki.ros.org/Bags/Format/2.0), record by record from the start: no index is
// needed, and a bag that was never closed (.active) is read as far as it goes.
#pragma once

#include <optional>
#include <string>

#include "tools/wheelwright/import/formats/ros/bag_recording.hpp"
#include "tools/wheelwright/import/formats/ros/storage/file_bytes.hpp"

namespace wheelwright::import::ros {

inline constexpr std::string_view bag1_format = "ROS 1 bag (version 2.0";

// Adds the messages of a file. `label` begins remarks: empty, or the name of a part of a split bag and ": ".
// Returns why the file cannot be read, if so.
std::optional<std::string> scan_bag1(FileBytes& file, const std::string& label, BagRecording& recording);

}  // namespace wheelwright::import::ros

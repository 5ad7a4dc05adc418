// The SQLite files of rosbag2 (.db3): tables of topics, of messages and, since Iron, of message definitions
// (ros2/rosbag2, rosbag2_storage_sqlite3). The file is opened read-only and as unchangeable, so that nothing
// is ever written, not even a journal beside it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "tools/wheelwright/import/formats/ros/bag_recording.hpp"

namespace wheelwright::import::ros {

inline constexpr std::string_view db3_format = "ROS 2 bag (SQLite";

// Adds the messages of a file. `label` begins remarks: empty, or the name of a part of a split bag and ": ".
// Returns why the file cannot be read, if so.
std::optional<std::string> scan_db3(const std::filesystem::path& path, const std::string& label,
                                    BagRecording& recording);

}  // namespace wheelwright::import::ros

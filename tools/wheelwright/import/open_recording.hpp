// Opens any file that the readers of formats/ know. The content decides, not the name.
#pragma once

#include <filesystem>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// A file, or the folder of a ROS 2 bag.
ReadResult open_recording(const std::filesystem::path& path);

}  // namespace wheelwright::import

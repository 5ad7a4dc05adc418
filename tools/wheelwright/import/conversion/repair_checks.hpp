// What a drive log may hold that its format allows and that would mislead: counters that wrap, rows out of
// order that look like a new run, holes of hours, stamps in bunches, milliseconds for seconds.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "model/log/drive_log.hpp"

namespace wheelwright::import {

// What has to be put right in the runs of one file, in a few words; nothing where they are sound.
std::optional<std::string> find_repair(std::span<const DriveLog> runs);

// Whether a file calls itself a drive log, in its first line.
bool is_drive_log(const std::filesystem::path& path);

}  // namespace wheelwright::import

// Drive logs as files: CSV, version 1, one row per sample (README.md says which columns).
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright::config {

// Of either sign: beyond it not every whole number is a double.
inline constexpr double largest_tick_count = 9e15;

// What is wrong with a log, where, and what would be right, in one line.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Reads a file of one or more runs: a new run begins where the time column starts again below one second.
// Throws LogError for anything else that is not as the format says, and for a last row that was cut short.
// A file without `period_s` gets the median
// distance of its samples; an empty command field holds the command of the row before.
std::vector<DriveLog> load_drive_logs(const std::filesystem::path& path);

// The same for a file that must hold exactly one run.
DriveLog load_drive_log(const std::filesystem::path& path);

// The same from a text; `name` stands for the file in messages.
std::vector<DriveLog> parse_drive_logs(const std::string& text, const std::string& name);

// Writes a log whole or not at all (temporary file, then rename); throws LogError where that fails.
void save_drive_log(const DriveLog& log, const std::filesystem::path& path);

// The same for runs of one robot, one after the other in one file; each has to begin below one second. The
// first says the metadata.
void save_drive_logs(const std::vector<DriveLog>& runs, const std::filesystem::path& path);

}  // namespace wheelwright::config

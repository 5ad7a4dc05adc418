// A run as its files tell it: a drive log, a pose log, or both, put together tick by tick.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "config/load/csv_table.hpp"
#include "daemon/recording/mcap/robot_recording.hpp"

namespace wheelwright::tools {

struct RecordedRun {
  std::optional<config::CsvTable> drive;  // commands, counts, sensors, reference poses
  std::optional<config::CsvTable> poses;  // poses and speeds by model, odometry, filter; or `x,y,theta` alone
};

// `path` is the folder of a run, with drive_log.csv, pose_log.csv or both in it, or one file of either kind.
// Times must rise. Throws config::LogError for what cannot be read, UsageError for a folder without logs.
RecordedRun load_recorded_run(const std::string& path);

// Calls `take` for each tick in the order of time; rows of both files with the same time are one tick.
void for_each_tick(const RecordedRun& run, const std::function<void(const mcap::TickValues&)>& take);

// Metadata of both files together: robot, wheel base, period, scale, pose source.
std::map<std::string, std::string> metadata_of(const RecordedRun& run);

}  // namespace wheelwright::tools

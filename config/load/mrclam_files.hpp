// Runs of the UTIAS Multi-Robot Cooperative Localization and Mapping data set (K. Leung and others, 2009):
// iRobot Create robots without encoders, commanded by forward and angular speed, seen by motion capture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/sensor_period.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::config {

struct MrclamOptions {
  double wheel_base_m = 0.258;         // of a Create; the files do not say it
  double period_s = default_period_s;  // nominal period that the log is to state
};

struct MrclamRun {
  DriveLog log;
  std::size_t commands = 0;           // rows of the odometry file that are in the log
  std::size_t superseded = 0;         // rows of it at whose very time another command follows
  std::size_t references = 0;         // rows of the ground truth that are in the log
  std::size_t references_before = 0;  // left out: the command was not known yet
  std::size_t references_after = 0;   // left out: the command was not known any more
};

// Joins the two files of one robot, whose clocks agree.
//
// The log has one row at each time at which a command was sent or a pose was measured, and nothing is
// resampled. A command holds until the next, so that its integral over any interval is exact at whatever
// times the rows lie (CommandTimeline), and a free run at a fixed period takes the mean of each of its
// periods. A pose stands at its own time to the microsecond; moved to a grid of 18 ms it would be off by up
// to 9 ms, which is 0.8 mm at 0.086 m/s and 5 mrad at 0.57 rad/s: as much as the capture's own noise, and
// correlated with the speed. Where the capture lost the robot there are no poses, where the command link
// paused there are no commands, and both stay visible as they were. Headings stay wrapped as they were
// measured. Time starts with the first command; poses before it and after the last command are left out,
// since nobody knows what was commanded then.
//
// Numbers are separated by blanks, lines that start with # are remarks. Throws LogError with file and line
// for anything else: another number of fields, no number, an impossible speed, time that falls, no common
// time.
MrclamRun load_mrclam_run(const std::filesystem::path& odometry, const std::filesystem::path& ground_truth,
                          const MrclamOptions& options = {});

// The same from texts; the names stand for the files in messages.
struct MrclamText {
  std::string name;
  std::string text;
};
MrclamRun parse_mrclam_run(const MrclamText& odometry, const MrclamText& ground_truth,
                           const MrclamOptions& options = {});

}  // namespace wheelwright::config

// The logs of a command line: drive logs as they are, and any other file that can be made one.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/log/drive_log.hpp"
#include "tools/wheelwright/common/progress_line.hpp"

namespace wheelwright::tools {

// What is said of logs that are no drive logs.
struct ImportOptions {
  std::string mapping;                // file, or empty
  std::vector<std::string> settings;  // KEY=VALUE, each on top of the file

  bool empty() const { return mapping.empty() && settings.empty(); }
};

// Adds --mapping and --set.
void add_import_options(CLI::App& command, ImportOptions& options);

struct LogInput {
  std::vector<std::string> paths;
  ImportOptions import;
  std::vector<std::string> of_the_same_robot =
      {};  // further logs, which tell what columns and units mean too
};

// All runs of all files, in order. A file that is no drive log, or a drive log whose time or counters have to
// be put right, is imported; what was done is said on `err`, one line each. Files of the same columns are
// understood together: what a duty of 100 leads to is one figure for all of them. Throws config::LogError
// where a file cannot be used, and config::ConfigError for the mapping.
std::vector<DriveLog> load_all_runs(const LogInput& input, std::ostream& err);
// As the first part of longer work; which file it is at is shown.
std::vector<DriveLog> load_all_runs(const LogInput& input, std::ostream& err, ProgressLine& progress);

// The same for a command that wants exactly one run.
DriveLog load_one_run(const LogInput& input, std::ostream& err);

// Runs of one wheel alone ("# one_wheel: left"), once more as runs of the other wheel, so that a model of two
// wheels can be fitted to what is known of one; other runs as they are.
std::vector<DriveLog> with_wheel_on_both_sides(std::vector<DriveLog> runs);

}  // namespace wheelwright::tools

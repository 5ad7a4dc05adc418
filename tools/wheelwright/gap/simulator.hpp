// A simulator of somebody else's, run on the commands of real runs.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright::tools {

struct Simulator {
  std::string command;     // for the shell; {commands} and {out} stand for the paths of two files
  double limit_s = 120.0;  // of one run
};

// What a run of it was given, and what it wrote.
struct SimulatorRun {
  std::filesystem::path commands;
  std::filesystem::path out;
};

// Throws UsageError where the command does not name both files.
void check_simulator(const Simulator& simulator);

// Runs it once for each run, one after the other; `folder` is made. {commands} is a CSV file with the columns
// t, cmd_left, cmd_right in s and m/s, below lines with '#' for wheel base and period; {out} is what it has
// to write, a log of any format that import reads. Returns the files in order. Throws UsageError with the
// command's last line where it fails, writes nothing, or takes longer than its limit, which ends it; and
// before anything runs where a file in the way is not of an earlier run of a simulator, or is one of `runs`.
// `before_each` is called with the number of the run.
std::vector<SimulatorRun> run_simulator(const Simulator& simulator, std::span<const DriveLog> runs,
                                        const std::filesystem::path& folder,
                                        const std::function<void(std::size_t)>& before_each);

}  // namespace wheelwright::tools

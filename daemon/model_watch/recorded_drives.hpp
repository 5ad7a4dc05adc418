// The drives that a robot has recorded, for the watch over its model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace wheelwright::daemon {

struct DriveChoice {
  std::string robot;                      // as the head of a drive log names it
  std::string not_before;                 // date and time, ISO 8601 in UTC; empty: all
  std::size_t at_most = 6;                // the newest ones
  std::uintmax_t min_bytes = 40'000;      // some ten seconds of driving
  std::uintmax_t max_bytes = 24U << 20U;  // of all together
};

// Drive logs in the run folders below `log_folder`, in the order in which they were recorded. `newest`, the
// run that has just ended, is among them whenever it began.
std::vector<std::filesystem::path> recorded_drives(const std::filesystem::path& log_folder,
                                                   const std::filesystem::path& newest,
                                                   const DriveChoice& choice);

// When a run began, as its folder's name says it: "2026-11-26T05:32:04Z"; empty for any other name.
std::string run_time(const std::filesystem::path& run_folder);

}  // namespace wheelwright::daemon

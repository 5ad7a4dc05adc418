#include "daemon/model_watch/recorded_drives.hpp"

#include <algorithm>
#include <fstream>

namespace wheelwright::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t time_letters = 20;  // of 2026-11-26T05-32-04Z

bool is_of_robot(const fs::path& log, const std::string& robot) {
  std::ifstream file(log);
  std::string line;
  while (std::getline(file, line) && line.starts_with('#')) {
    if (line == "# robot: " + robot) return true;
  }
  return false;
}

}  // namespace

std::string run_time(const fs::path& run_folder) {
  std::string name = run_folder.filename().string().substr(0, time_letters);
  if (name.size() < time_letters || name[10] != 'T' || name.back() != 'Z') return "";
  name[13] = name[16] = ':';
  return name;
}

std::vector<fs::path> recorded_drives(const fs::path& log_folder, const fs::path& newest,
                                      const DriveChoice& choice) {
  std::error_code error;
  std::vector<fs::path> runs;
  for (const auto& entry : fs::directory_iterator(log_folder, error)) {
    const std::string time = run_time(entry.path());
    if (!time.empty() && (entry.path() == newest || time >= choice.not_before)) runs.push_back(entry.path());
  }
  std::sort(runs.begin(), runs.end(), std::greater<>());
  std::vector<fs::path> drives;
  std::uintmax_t bytes = 0;
  for (const fs::path& run : runs) {
    const fs::path log = run / "drive_log.csv";
    if (drives.size() == choice.at_most || !fs::is_regular_file(fs::symlink_status(log, error))) continue;
    const std::uintmax_t size = fs::file_size(log, error);
    if (error || size < choice.min_bytes || bytes + size > choice.max_bytes) continue;
    if (!is_of_robot(log, choice.robot)) continue;
    drives.push_back(log);
    bytes += size;
  }
  std::reverse(drives.begin(), drives.end());
  return drives;
}

}  // namespace wheelwright::daemon

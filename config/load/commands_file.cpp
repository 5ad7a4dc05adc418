#include "config/load/commands_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/load/drive_log_file.hpp"
#include "config/load/text_format.hpp"

namespace wheelwright::config {
namespace {

constexpr double rounding_m_s = 1e-9;
constexpr double longest_s = 86400.0;
constexpr std::size_t max_commands = 100'000;

void check_speed(const DriveLog& log, std::size_t row, double largest_speed_m_s) {
  const WheelPair& command = log.samples[row].command_m_s;
  const double fastest = std::max(std::abs(command.left), std::abs(command.right));
  if (fastest <= largest_speed_m_s + rounding_m_s) return;
  throw ConfigError(log.name + ":" + std::to_string(log.first_line + row) + ": commands " +
                    plain_number(fastest) + " m/s, more than limits.largest_speed_m_s (" +
                    plain_number(largest_speed_m_s) +
                    ") allows; raise it, or plan the drive with 'wheelwright gap --largest-speed'");
}

}  // namespace

CommandedDrive load_commands(const std::filesystem::path& path, double largest_speed_m_s) {
  const DriveLog log = load_drive_log(path);
  for (std::size_t row = 0; row < log.samples.size(); ++row) check_speed(log, row, largest_speed_m_s);
  CommandedDrive drive = commanded_drive_of(log);
  if (drive.rows.size() > max_commands) {  // they become part of the run's config.yaml
    throw ConfigError(log.name + ": commands " + std::to_string(drive.rows.size()) +
                      " changes of speed, but at most " + std::to_string(max_commands) +
                      " can be driven in one run; split the file");
  }
  drive.name = path.filename().string();
  return drive;
}

CommandedDrive read_commands(YamlReader& section, double largest_speed_m_s) {
  const Range speeds{-largest_speed_m_s - rounding_m_s, largest_speed_m_s + rounding_m_s, "m/s"};
  CommandedDrive drive;
  drive.name = section.text("name");
  drive.duration_s = section.number("duration_s", {0.0, longest_s, "s"});
  const auto times = section.numbers("t_s", {0.0, longest_s, "s"});
  const auto left = section.numbers("left_m_s", speeds);
  const auto right = section.numbers("right_m_s", speeds);
  if (times.empty() || left.size() != times.size() || right.size() != times.size()) {
    section.fail("t_s", "must hold one time for each number of left_m_s and right_m_s, and at least one");
  }
  if (times.front() != 0.0 || !std::ranges::is_sorted(times)) {
    section.fail("t_s", "must begin at 0 and rise from number to number");
  }
  for (std::size_t i = 0; i < times.size(); ++i) drive.rows.push_back({times[i], {left[i], right[i]}});
  section.finish();
  return drive;
}

}  // namespace wheelwright::config

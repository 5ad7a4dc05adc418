#include "tools/wheelwright/log_checks.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "config/load/drive_log_file.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/commands.hpp"

namespace wheelwright::tools {
namespace {

constexpr double roomba_limit_m_s = 0.5;  // of Drive Direct, Open Interface
constexpr double any_robot_limit_m_s = 5.0;

bool is_roomba(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name.find("roomba") != std::string::npos || name.find("create") != std::string::npos;
}

}  // namespace

void check_output(const std::string& output, const std::vector<std::string>& inputs) {
  for (const auto& input : inputs) {
    std::error_code no_such_file;
    if (!std::filesystem::equivalent(output, input, no_such_file)) continue;
    throw UsageError("--output is " + output + ", which would replace an input; give it another name");
  }
}

std::string robot_name(const DriveLog& log) {
  for (const auto& [key, value] : log.other_metadata) {
    if (key == "robot") return value;
  }
  return "unknown";
}

std::vector<DriveLog> load_all_runs(const std::vector<std::string>& paths) {
  std::vector<DriveLog> runs;
  for (const auto& path : paths) {
    for (auto& run : config::load_drive_logs(path)) runs.push_back(std::move(run));
  }
  return runs;
}

std::optional<std::string> find_impossible_command(const DriveLog& log, std::optional<double> limit_m_s) {
  const bool known_robot = is_roomba(robot_name(log));
  const double limit = limit_m_s.value_or(known_robot ? roomba_limit_m_s : any_robot_limit_m_s);
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const WheelPair& command = log.samples[k].command_m_s;
    const double largest = std::max(std::abs(command.left), std::abs(command.right));
    if (largest <= limit) continue;
    const std::string robot =
        known_robot && !limit_m_s ? "a Roomba or Create takes" : "the robot is assumed to take";
    return log.name + ":" + std::to_string(log.first_line + k) + ": a command of " +
           config::plain_number(largest) + " m/s, but " + robot + " at most " + config::plain_number(limit) +
           " m/s; delete the row if it is garbage";
  }
  return std::nullopt;
}

void warn_of_doubtful_log(const DriveLog& log, const LinearModel& model, std::ostream& err) {
  if (const auto impossible = find_impossible_command(log, std::nullopt)) {
    err << "wheelwright: warning: " << *impossible << "\n";
  }
  if (std::abs(log.wheel_base_m - model.wheel_base_m) > 1e-6) {
    err << "wheelwright: warning: " << log.name << ": its wheel base is "
        << config::plain_number(log.wheel_base_m) << " m, but that of the model is "
        << config::plain_number(model.wheel_base_m) << " m; is it the same robot?\n";
  }
}

}  // namespace wheelwright::tools

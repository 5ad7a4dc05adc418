// Drive logs to files.
#include <algorithm>
#include <array>
#include <span>

#include "config/load/drive_log_columns.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/text_format.hpp"

namespace wheelwright::config {
namespace {

using namespace drive_log;

void append_optional(std::string& text, const std::optional<double>& value, int decimals) {
  if (value) text += fixed_number(*value, decimals);
}

bool any(const DriveLog& log, std::optional<double> DriveSample::*field) {
  return std::any_of(log.samples.begin(), log.samples.end(),
                     [field](const DriveSample& sample) { return (sample.*field).has_value(); });
}

struct OptionalColumn {
  Column column;
  std::optional<double> DriveSample::*field;
  int decimals;
};

constexpr std::array<OptionalColumn, 5> optional_columns{{{ref_x, &DriveSample::reference_x_m, 6},
                                                          {ref_y, &DriveSample::reference_y_m, 6},
                                                          {ref_theta, &DriveSample::reference_theta_rad, 6},
                                                          {gyro_z, &DriveSample::gyro_z_rad_s, 6},
                                                          {battery_v, &DriveSample::battery_v, 3}}};

std::string head_of(const DriveLog& log) {
  std::string text = "# wheelwright_drive_log: 1\n";
  for (const auto& [key, value] : log.other_metadata) text += "# " + key + ": " + value + "\n";
  text += "# wheel_base_m: " + plain_number(log.wheel_base_m) + "\n";
  text += "# period_s: " + plain_number(log.period_s) + "\n";
  if (log.metres_per_tick) {
    text += "# metres_per_tick_left: " + plain_number(log.metres_per_tick->left) + "\n";
    text += "# metres_per_tick_right: " + plain_number(log.metres_per_tick->right) + "\n";
  }
  return text;
}

void append_row(std::string& text, const DriveSample& sample, bool has_counts,
                const std::vector<OptionalColumn>& used) {
  text += fixed_number(sample.t_s, 6) + "," + fixed_number(sample.command_m_s.left, 6) + "," +
          fixed_number(sample.command_m_s.right, 6);
  if (has_counts) {
    text += ",";
    if (sample.ticks) text += std::to_string(sample.ticks->left);
    text += ",";
    if (sample.ticks) text += std::to_string(sample.ticks->right);
  }
  for (const auto& entry : used) {
    text += ",";
    append_optional(text, sample.*entry.field, entry.decimals);
  }
  text += "\n";
}

void save(std::span<const DriveLog> runs, const std::filesystem::path& path) {
  const bool has_counts = runs.front().metres_per_tick.has_value();
  std::string text = head_of(runs.front()) + "t,cmd_left,cmd_right";
  if (has_counts) text += ",ticks_left,ticks_right";
  std::vector<OptionalColumn> used;
  for (const auto& entry : optional_columns) {
    const auto has = [&entry](const DriveLog& log) { return any(log, entry.field); };
    if (std::none_of(runs.begin(), runs.end(), has)) continue;
    used.push_back(entry);
    text += "," + std::string(column_names[entry.column]);
  }
  text += "\n";
  for (const auto& run : runs) {
    for (const auto& sample : run.samples) append_row(text, sample, has_counts, used);
  }
  if (const auto error = write_output({path, OutputKind::drive_log}, text)) throw LogError(*error);
}

}  // namespace

void save_drive_log(const DriveLog& log, const std::filesystem::path& path) {
  save({&log, 1}, path);
}

void save_drive_logs(const std::vector<DriveLog>& runs, const std::filesystem::path& path) {
  save(runs, path);
}

}  // namespace wheelwright::config

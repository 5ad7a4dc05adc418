// Drive logs to files.
#include <algorithm>
#include <array>

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

}  // namespace

void save_drive_log(const DriveLog& log, const std::filesystem::path& path) {
  std::string text = "# wheelwright_drive_log: 1\n";
  for (const auto& [key, value] : log.other_metadata) text += "# " + key + ": " + value + "\n";
  text += "# wheel_base_m: " + plain_number(log.wheel_base_m) + "\n";
  text += "# period_s: " + plain_number(log.period_s) + "\n";
  if (log.metres_per_tick) {
    text += "# metres_per_tick_left: " + plain_number(log.metres_per_tick->left) + "\n";
    text += "# metres_per_tick_right: " + plain_number(log.metres_per_tick->right) + "\n";
  }
  text += "t,cmd_left,cmd_right";
  if (log.metres_per_tick) text += ",ticks_left,ticks_right";
  std::vector<OptionalColumn> used;
  for (const auto& entry : optional_columns) {
    if (!any(log, entry.field)) continue;
    used.push_back(entry);
    text += "," + std::string(column_names[entry.column]);
  }
  text += "\n";
  for (const auto& sample : log.samples) {
    text += fixed_number(sample.t_s, 6) + "," + fixed_number(sample.command_m_s.left, 6) + "," +
            fixed_number(sample.command_m_s.right, 6);
    if (log.metres_per_tick) {
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
  if (const auto error = write_output({path, OutputKind::drive_log}, text)) throw LogError(*error);
}

}  // namespace wheelwright::config

// The columns of a drive log that its format names, for reader and writer.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace wheelwright::config::drive_log {

enum Column : std::size_t {
  time,
  cmd_left,
  cmd_right,
  ticks_left,
  ticks_right,
  ref_x,
  ref_y,
  ref_theta,
  gyro_z,
  battery_v,
  column_count
};

inline constexpr std::array<std::string_view, column_count> column_names{
    "t",     "cmd_left", "cmd_right", "ticks_left", "ticks_right",
    "ref_x", "ref_y",    "ref_theta", "gyro_z",     "battery_v"};

}  // namespace wheelwright::config::drive_log

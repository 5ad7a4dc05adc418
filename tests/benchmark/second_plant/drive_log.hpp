#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "tests/benchmark/second_plant/plant.hpp"
#include "tests/benchmark/second_plant/wheels.hpp"

namespace second_plant {

// What a run was measured with.
struct SensorSet {
  bool ticks = true;
  bool poses = false;
  bool only_end_poses = false;
  bool battery = false;
  double pose_every_s = 0.0;  // 0 = every row
  double position_noise_m = 0.002;
  double heading_noise_rad = 0.002;
};

struct LogRow {
  double time_s = 0.0;
  PerWheel<double> command_m_s{};
  PerWheel<long> ticks{};
  std::optional<Pose> reference;
  double battery_v = 0.0;
};

struct DriveLog {
  double wheel_base_m = 0.0;
  double period_s = 0.0;
  double metres_per_tick = 0.0;
  std::vector<LogRow> rows;
};

// Writes a drive log, version 1, with the columns that the sensors give.
void write_drive_log(const std::filesystem::path& file, const DriveLog& log, const SensorSet& sensors);

}  // namespace second_plant

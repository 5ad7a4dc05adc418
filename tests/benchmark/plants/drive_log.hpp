#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/sensors.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants {

struct LogRow {
  double time_s = 0.0;
  PerWheel<double> command_m_s{};
  PerWheel<long> ticks{};
  std::optional<Pose> reference;
  double battery_v = 0.0;
};

// Digits behind the point: what the robot's logger resolves.
struct LogDigits {
  int time = 5;
  int command = 3;
  int pose = 5;
  int battery = 3;
};

struct DriveLog {
  double wheel_base_m = 0.0;
  double period_s = 0.0;
  double metres_per_tick = 0.0;
  LogDigits digits;
  std::vector<LogRow> rows;
};

// Writes a drive log, version 1, with the columns that the sensors give.
void write_drive_log(const std::filesystem::path& file, const DriveLog& log, const SensorSet& sensors);

}  // namespace plants

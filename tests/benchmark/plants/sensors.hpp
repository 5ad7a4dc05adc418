#pragma once

#include <string>

namespace plants {

enum class Sensing { ticks, poses, ticks_and_poses, ticks_and_ends };

// As the answers and the names of cases say it.
inline std::string label(Sensing sensing) {
  switch (sensing) {
    case Sensing::ticks:
      return "ticks";
    case Sensing::poses:
      return "poses";
    case Sensing::ticks_and_poses:
      return "ticks+poses";
    case Sensing::ticks_and_ends:
      break;
  }
  return "ticks+ends";
}

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

inline SensorSet sensor_set(Sensing sensing) {
  SensorSet sensors;
  sensors.ticks = sensing != Sensing::poses;
  sensors.poses = sensing != Sensing::ticks;
  sensors.only_end_poses = sensing == Sensing::ticks_and_ends;
  return sensors;
}

}  // namespace plants

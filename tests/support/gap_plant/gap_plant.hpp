// The robot of the gap benchmark: written for it alone, and in other formulas than an ordinary library of
// effects, so that finding an effect in its logs says something. Integrated at 1 kHz or finer; everything by
// seed.
#pragma once

#include <cstdint>
#include <vector>

#include "model/log/drive_log.hpp"
#include "tests/support/gap_plant/plant_parameters.hpp"

namespace wheelwright::test {

// The circumstances of one run.
struct GapRunPlan {
  double period_s = 0.018;
  Pose start;                // of the middle of the axle, in the frame of the reference
  double charge_used = 0.0;  // of the battery, when the run begins and when it ends
  double charge_used_at_end = 0.1;
  double hour = 12.0;         // of the day
  bool wrap_heading = false;  // the reference gives its heading in (-pi, pi]
  std::uint64_t seed = 1;
};

// What the logs do not say, at the time of each row.
struct PlantTruth {
  WheelPair rim_m;  // travel of the wheels as the encoders see them
  WheelPair rim_m_s;
  Pose pose;            // of the middle of the axle
  double supply = 1.0;  // of the drive
};

struct PlantRun {
  DriveLog log;  // every channel on every row
  std::vector<PlantTruth> truth;
};

// Drives the commands, one per period.
PlantRun drive_plant(const PlantParameters& robot, const std::vector<WheelPair>& commands_m_s,
                     const GapRunPlan& plan);

}  // namespace wheelwright::test

#pragma once

#include <vector>

#include "tests/benchmark/fourth_plant/battery.hpp"
#include "tests/benchmark/fourth_plant/block.hpp"
#include "tests/benchmark/fourth_plant/wheel_drive.hpp"

namespace plants::fourth {

inline constexpr double fine_step_s = 0.001;

// Where imperfections sit, in the order in which the signal passes. A robot without any is linear.
struct Diagram {
  std::vector<PairBlock> radio;  // both commands at once
  PerWheel<Chain> command;
  PerWheel<Chain> drive;  // between controller and motor
  PerWheel<Chain> load;   // turns the motor's speed into a loss of drive
  PerWheel<Chain> gear;   // seen by the encoder
  PerWheel<Chain> count;  // in the encoder alone
  PerWheel<Chain> floor;  // not seen by the encoder
  std::vector<BodyBlock> body;
};

struct Robot {
  double wheel_base_m = 0.25;
  double top_m_s = 0.4;
  double metres_per_turn = 0.2;
  double metres_per_tick = 0.0003;
  double dead_time_s = 0.03;
  PerWheel<DriveSpec> drives;
  double wheel_noise_m_s = 0.001;
  double wheel_noise_memory_s = 0.2;
  BatterySpec battery;
  double marker_x_m = 0.0;  // of the point that the reference measures
  double marker_y_m = 0.0;
  double reference_latency_s = 0.0;
  double period_s = 0.02;
  double jitter_s = 0.0;
  Diagram diagram;
};

}  // namespace plants::fourth
